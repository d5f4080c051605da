// From the model to URDF.
#pragma once

#include <string>

#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// A URDF of the same physics, complete in itself: one URDF link for each link, a revolute, continuous or prismatic
// joint for each joint, in the model's order and with the model's names.
// - A link that has a user frame of its own name gets that frame as its URDF frame, and its joint the axis that z is
//   there, unless URDF cannot say it: where the frame of a revolute joint's link is off the axis, or the base's is not
//   the link frame. Any other gets the model's link frame and the axis z.
// - All other user frames that are not hidden become massless links of their names, `<frame>_frame` where a link has
//   that name, on fixed joints `<link>_fixed`.
// - A floating base hangs on a root link without mass, `world`, by a joint of type `floating`, `floating_base`.
// - Joints that know no bounds become `continuous`. What else URDF demands of a `limit` and nobody knows is 1e9.
// Names that are added get `_2` and so on where they are taken. Rotations of quarter turns, and about one axis, are
// exact, any others within 1e-15 rad; mass properties are rounded once. The robot must have no parameters.
std::string urdf(const model::KinematicTree& tree);

}  // namespace robcogen::exporting
