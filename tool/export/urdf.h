// From the model to URDF.
#pragma once

#include <string>

#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// A URDF of the same physics, complete in itself: one URDF link for each link, and one revolute, continuous or
// prismatic joint for each joint, in the model's order and with the model's names.
// - The URDF frame of a link is the user frame that has the name of the link, and the axis of its joint is the link's z
//   axis in that frame. If there is no such frame, or URDF cannot express it (the frame is off the axis of a revolute
//   joint, or the frame of the base is not its link frame), the URDF frame is the link frame, and the axis is z.
// - All other user frames that are not hidden become massless links of their names, or `<frame>_frame` if a link has
//   that name, on fixed joints `<link>_fixed`.
// - A floating base hangs on a massless root link, `world`, by the joint `floating_base` of type `floating`.
// - Revolute joints without position limits become `continuous`. Other limits that URDF requires and the model does not
//   have are 1e9.
// - A joint that follows another mimics it. Loops, and joints that follow several others, become elements of URDF+,
//   which must be able to express all of them (has_urdf_form, may_be_urdf_loop).
// There must be no helical joint.
// Names that are added get `_2` and so on if they are taken. Rotations of quarter turns, and about one axis, are exact,
// others are within 1e-15 rad; mass properties are rounded once. The robot must not have parameters.
std::string urdf(const model::KinematicTree& tree);

// Whether URDF or URDF+ can express this coupling. In URDF, a joint follows one other, or stands still where another
// moves. In URDF+, it also follows through a loop, or by sums over the joints between two links.
bool has_urdf_form(const model::KinematicTree& tree, const model::Coupling& coupling);

}  // namespace robcogen::exporting
