// A joint as the recursions use it: what it adds to the motion of its child, and which part of a force it feels.
//
// All that the recursions know of joint types is here. The motion subspace S of a joint is constant in the axes of the
// child C, about the child's origin, and along its z axis: (0 0 1 0 0 0) for a revolute joint, (0 0 0 0 0 1) for a
// prismatic one, (0 0 1 0 0 p) for a helical one with pitch p (Featherstone 2008, table 4.1).
//
// The components of a spherical joint are three joints in a row with the same child frame, about its x, y and z axis:
// the child turns with the rates of all three. So the first component changes a motion by all three rates, and the
// others do not change it.
#pragma once

#include "algorithm/spatial/link_motion.h"
#include "algorithm/spatial/spatial_inertia.h"

namespace robcogen::algorithm {

struct Joint {
  int index = 0;
  int child = 0;  // link
  model::JointType type = model::JointType::revolute;
  Expression pitch = {};  // of a helical joint, m per radian
  int axis = 2;           // of a component of a spherical joint

  bool is_spherical() const { return type == model::JointType::spherical; }
};

Joint joint_of(Trace& trace, int index);

// ---- The motion subspace.

// S.
Motion subspace(const Joint& joint, Graph& graph);
// V_C += S rate.
void add_rate(const Joint& joint, const Expression& rate, Motion& V_C);
// The same for the two parts of V_C.
void add_rate(const Joint& joint, const Expression& rate, Vector3& w, Vector3& v);
// Adds S qd, the joint's part of the motion of its child. The first component of a spherical joint adds it for all
// three. `qd` by joint.
void add_rates(const Joint& joint, const std::vector<Expression>& qd, Vector3& w, Vector3& v);
// S' F_C: the joint force.
Expression project(const Joint& joint, const Force& F_C);
// Changes F_C so that S' F_C is `value`.
void set_projection(const Joint& joint, const Expression& value, Force& F_C);
// Removes the part of V_C along S and returns it.
Expression take_rate(const Joint& joint, Motion& V_C);
// S x V: the change of a motion at unit rate of the joint, in axes that do not move with it.
Motion cross_subspace(const Joint& joint, const Motion& V_C);
// Whether the joint feels only the moment about z of a force on its child.
bool feels_only_moment(const Joint& joint);

// ---- Across the joint, from the parent P to the child C. Rates and accelerations by joint.

Motion across_joint(const Joint& joint, const Pose& X_PC, const Motion& V_P, const std::vector<Expression>& qd);
LinkMotion across_joint(
    const Joint& joint,
    const Pose& X_PC,
    const LinkMotion& parent,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd);
// The motion of the child's frame if the joint stood still.
LinkMotion carried_motion(const Pose& X_PC, const LinkMotion& parent);

// ---- Inertias.

// I S: the force that accelerates the body by one unit of the joint from rest, and its momentum at unit rate.
Force times_subspace(const MassProperties& body, const Joint& joint);
Force times_subspace(const SpatialInertia& body, const Joint& joint);
// I - U U' / D, the inertia that remains when the joint yields: U = I S, `gain` = U / D. If D = S' U, the row and
// column of S become zero, and `released` sets them to zero.
SpatialInertia reduced(const SpatialInertia& body, const Force& U, const Force& gain);
SpatialInertia released(const SpatialInertia& body, const Joint& joint, const Force& U, const Force& gain);

}  // namespace robcogen::algorithm
