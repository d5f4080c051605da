// From the model to a robot document.
#pragma once

#include "language/kinematics/document.h"
#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// The robot in the Kinematics-DSL; places in it mean nothing. Everything of the model but joint limits, which the
// language cannot say.
language::kinematics::Document kinematics_document(const model::KinematicTree& tree);

}  // namespace robcogen::exporting
