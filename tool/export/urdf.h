// From the model to URDF.
#pragma once

#include <string>

#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// A URDF of the same physics, complete in itself: one URDF link for each link, a revolute, continuous or prismatic
// joint for each joint, in the model's order and with the model's names.
// - The URDF frame of a link is its user frame of its own name, and the axis of its joint is z in that frame, except
// where
//   URDF cannot express this: when the frame of the link of a revolute joint is off the axis, or that of the base is
//   not the link frame. Otherwise it is the link frame of the model, and the axis is z.
// - All other user frames that are not hidden become massless links of their names, `<frame>_frame` where a link has
//   that name, on fixed joints `<link>_fixed`.
// - A floating base hangs on a root link without mass, `world`, by a joint of type `floating`, `floating_base`.
// - Revolute joints without position limits become `continuous`. Other limits that URDF requires and the model does not
//   have are 1e9.
// - A joint that follows another mimics it. Loops, and joints that follow several others, are elements of URDF+; all of
//   them must be such that it can say them (has_urdf_form, may_be_urdf_loop).
// There must be no helical joint.
// Names that are added get `_2` and so on when they are taken. Rotations of quarter turns, and about one axis, are
// exact, others within 1e-15 rad; mass properties are rounded once. The robot must not have parameters.
std::string urdf(const model::KinematicTree& tree);

// Whether URDF can say this coupling: a joint that follows one other, or that stands still where another moves; of
// URDF+, through a loop, or sums over joints between two links.
bool has_urdf_form(const model::KinematicTree& tree, const model::Coupling& coupling);

}  // namespace robcogen::exporting
