// From the model to a robot document.
#pragma once

#include <vector>

#include "language/kinematics/document.h"
#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// The robot in the Kinematics-DSL; places in it mean nothing. Everything of the model but joint limits, which the
// language cannot say.
language::kinematics::Document kinematics_document(const model::KinematicTree& tree);

// The joints with those of a link's ancestors before its own, in declaration order otherwise.
std::vector<int> joints_parents_first(const model::KinematicTree& tree);

// The same document with links and joints in that order, and ids along: the original tool takes it that a parent has a
// smaller id than its children. Positions of joints in q change with the order of the joints.
language::kinematics::Document numbered_parents_first(
    const model::KinematicTree& tree,
    language::kinematics::Document document);

}  // namespace robcogen::exporting
