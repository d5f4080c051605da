// From the model to URDF.
#pragma once

#include <string>

#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// A URDF of the same physics, complete in itself: one URDF link for each link, a revolute, continuous or prismatic
// joint for each joint, in the model's order and with the model's names.
// - A link that has a user frame of its own name gets that frame as its URDF frame, and its joint the axis that z is
// there;
//   any other gets the model's link frame and the axis z. All other user frames become massless links on fixed joints.
// - A floating base hangs on a root link without mass by a joint of type `floating`.
// - Joints that know no limits become `continuous`; a prismatic one gets bounds that mean none.
// The robot must have no parameters.
std::string urdf(const model::KinematicTree& tree);

}  // namespace robcogen::exporting
