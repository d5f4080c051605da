// From the model to a robot document.
#pragma once

#include <vector>

#include "language/kinematics/document.h"
#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// The robot in the Kinematics-DSL. Places are not set.
language::kinematics::Document kinematics_document(const model::KinematicTree& tree);

// The joints, parents before children, otherwise in declaration order.
std::vector<int> joints_parents_first(const model::KinematicTree& tree);

// The same document with links and joints in that order, and ids to match: the first RobCoGen assumes that a parent has
// a smaller id than its children. The order of the joints is the order of q.
language::kinematics::Document numbered_parents_first(
    const model::KinematicTree& tree,
    language::kinematics::Document document);

}  // namespace robcogen::exporting
