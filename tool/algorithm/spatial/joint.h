// Joints as the recursions use them: the motion that a joint adds to its child, S qd, and the joint force, S' F. All
// that depends on the type of a joint is here.
//
// The motion subspace S of a joint is constant in the axes of the child C, about the child's origin, and along the
// child's z axis: (0 0 1 0 0 0) for a revolute joint, (0 0 0 0 0 1) for a prismatic one, (0 0 1 0 0 p) for a helical
// one with pitch p in metres per radian (Featherstone 2008, table 4.1).
//
// A spherical joint is three joints in a row with one child frame, about the x, y and z axis of that frame. The child
// turns with the rates of all three: the first of these joints adds all three rates to a motion, the other two add
// nothing.
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
// The same for the two parts (w, v) of V_C.
void add_rate(const Joint& joint, const Expression& rate, Vector3& w, Vector3& v);
// Adds S qd, the joint's part of the motion of its child; the first joint of a spherical one adds the part of all
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
// Whether the joint force is the moment about z of the force on its child.
bool feels_only_moment(const Joint& joint);

// ---- Across the joint, from the parent P to the child C. Rates and accelerations by joint.

Motion across_joint(const Joint& joint, const Pose& X_PC, const Motion& V_P, const std::vector<Expression>& qd);
LinkMotion across_joint(
    const Joint& joint,
    const Pose& X_PC,
    const LinkMotion& parent,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd);
// The motion of the child's frame at zero joint velocity and acceleration.
LinkMotion carried_motion(const Pose& X_PC, const LinkMotion& parent);

// ---- Inertias.

// I S: the momentum of the body at unit rate of the joint, and the force that accelerates it from rest at unit
// acceleration of the joint.
Force times_subspace(const MassProperties& body, const Joint& joint);
Force times_subspace(const SpatialInertia& body, const Joint& joint);
// I - U U' / D, the inertia of a body behind a joint that moves freely: U = I S, `gain` = U / D. If D = S' U, the row
// and the column of I along S become zero; `released` sets them to zero, `reduced` computes them.
SpatialInertia reduced(const SpatialInertia& body, const Force& U, const Force& gain);
SpatialInertia released(const SpatialInertia& body, const Joint& joint, const Force& U, const Force& gain);

}  // namespace robcogen::algorithm
