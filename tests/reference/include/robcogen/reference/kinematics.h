// Poses, velocities and Jacobians of an articulated robot by products of 4 x 4 matrices, base coordinates throughout.
//
// Velocities and accelerations come from the product rule on those matrices (Uicker 1965), so no formula for Coriolis
// or centripetal terms is written anywhere. For a floating base, "at rest" means at rest in the inertial frame that
// coincides with the base frame at the instant considered.
#pragma once

#include <cassert>
#include <vector>

#include "robcogen/reference/algebra.h"
#include "robcogen/reflection.h"

namespace robcogen::reference {

using reflection::Robot;

// Base velocity and acceleration: twist and spatial acceleration in base coordinates, about the base origin; gravity
// not included. Both are zero for a fixed base.
template <class Scalar>
struct Motion {
  VectorX<Scalar> q, qd, qdd;
  Vector6<Scalar> base_velocity = Vector6<Scalar>::Zero();
  Vector6<Scalar> base_acceleration = Vector6<Scalar>::Zero();
};

// A motion at rest in the configuration q.
template <class Scalar>
Motion<Scalar> at_rest(const VectorX<Scalar>& q) {
  const VectorX<Scalar> zero = VectorX<Scalar>::Zero(q.size());
  return {q, zero, zero};
}

// Joints sorted so that each comes after the joint that supports its parent link.
inline std::vector<int> outward_order(const Robot& robot) {
  std::vector<int> joints;
  std::vector<int> links{0};
  for (std::size_t k = 0; k < links.size(); ++k) {
    for (int j = 0; j < robot.joints.size; ++j) {
      if (robot.joints[j].parent != links[k]) continue;
      joints.push_back(j);
      links.push_back(robot.joints[j].child);
    }
  }
  assert(static_cast<int>(joints.size()) == robot.joints.size && "the joints do not form a tree");
  return joints;
}

// The joints between a link and the base, from the link inwards.
inline std::vector<int> supporting_joints(const Robot& robot, int link) {
  std::vector<int> joints;
  for (int j = robot.links[link].parent_joint; j >= 0; j = robot.links[robot.joints[j].parent].parent_joint)
    joints.push_back(j);
  return joints;
}

// The motion of a joint as a matrix of its position: Rz(q) or Tz(q); and its first two derivatives by q.
template <class Scalar>
Matrix4<Scalar> joint_matrix(bool revolute, const Scalar& q) {
  return revolute ? rotation(2, q) : translation(Scalar(0), Scalar(0), q);
}

template <class Scalar>
Matrix4<Scalar> joint_matrix_derivative(bool revolute, const Scalar& q) {
  Matrix4<Scalar> m = Matrix4<Scalar>::Zero();
  if (revolute) {
    m(0, 0) = m(1, 1) = -std::sin(q);
    m(0, 1) = -std::cos(q);
    m(1, 0) = std::cos(q);
  } else {
    m(2, 3) = Scalar(1);
  }
  return m;
}

template <class Scalar>
Matrix4<Scalar> joint_matrix_second_derivative(bool revolute, const Scalar& q) {
  Matrix4<Scalar> m = Matrix4<Scalar>::Zero();
  if (revolute) {
    m(0, 0) = m(1, 1) = -std::cos(q);
    m(0, 1) = std::sin(q);
    m(1, 0) = -std::sin(q);
  }
  return m;
}

// Pose of each link in the base frame; the scalar may be complex.
template <class Scalar>
std::vector<Matrix4<Scalar>> link_poses(const Robot& robot, const VectorX<Scalar>& q) {
  std::vector<Matrix4<Scalar>> poses(static_cast<std::size_t>(robot.links.size), Matrix4<Scalar>::Identity());
  for (const int j : outward_order(robot)) {
    const reflection::Joint& joint = robot.joints[j];
    poses[static_cast<std::size_t>(joint.child)] = poses[static_cast<std::size_t>(joint.parent)] *
                                                   placement<Scalar>(joint.translation, joint.rotation) *
                                                   joint_matrix(joint.revolute, q(j));
  }
  return poses;
}

// left_X_right as a homogeneous transform; frames by index.
template <class Scalar>
Matrix4<Scalar> transform(const Robot& robot, const VectorX<Scalar>& q, int left, int right) {
  const std::vector<Matrix4<Scalar>> poses = link_poses(robot, q);
  const auto pose = [&](int frame) -> Matrix4<Scalar> {
    const reflection::Frame& f = robot.frames[frame];
    return poses[static_cast<std::size_t>(f.link)] * placement<Scalar>(f.translation, f.rotation);
  };
  return inverse_of(pose(left)) * pose(right);
}

// Pose of a link in the base frame, and the first and second time derivatives of that matrix at rest.
template <class Scalar>
struct LinkMotion {
  Matrix4<Scalar> pose = Matrix4<Scalar>::Identity();
  Matrix4<Scalar> rate = Matrix4<Scalar>::Zero();
  Matrix4<Scalar> second_rate = Matrix4<Scalar>::Zero();

  // rate = [w]x R and second_rate = ([w']x + [w]x [w]x) R in their rotation parts.
  Vector3<Scalar> angular_velocity() const {
    return axis_of<Scalar>(rotation_of(rate) * rotation_of(pose).transpose());
  }
  Vector3<Scalar> angular_acceleration() const {
    return axis_of<Scalar>(rotation_of(second_rate) * rotation_of(pose).transpose());
  }
  // Of a point fixed to the link, given in link coordinates.
  Vector3<Scalar> position(const Vector3<Scalar>& point) const { return apply(pose, point); }
  Vector3<Scalar> velocity(const Vector3<Scalar>& point) const { return apply(rate, point); }
  Vector3<Scalar> acceleration(const Vector3<Scalar>& point) const { return apply(second_rate, point); }

 private:
  static Vector3<Scalar> apply(const Matrix4<Scalar>& m, const Vector3<Scalar>& point) {
    return rotation_of(m) * point + origin_of(m);
  }
};

template <class Scalar>
std::vector<LinkMotion<Scalar>> link_motions(const Robot& robot, const Motion<Scalar>& motion) {
  std::vector<LinkMotion<Scalar>> links(static_cast<std::size_t>(robot.links.size));

  const Vector3<Scalar> w = motion.base_velocity.template head<3>();
  const Vector3<Scalar> v = motion.base_velocity.template tail<3>();
  LinkMotion<Scalar>& base = links[0];
  base.rate.template topLeftCorner<3, 3>() = skew(w);
  base.rate.template topRightCorner<3, 1>() = v;
  // The spatial acceleration is that of the body-fixed point passing a point at rest; the origin itself has w x v more.
  base.second_rate.template topLeftCorner<3, 3>() =
      skew<Scalar>(motion.base_acceleration.template head<3>()) + skew(w) * skew(w);
  base.second_rate.template topRightCorner<3, 1>() = motion.base_acceleration.template tail<3>() + skew(w) * v;

  for (const int j : outward_order(robot)) {
    const reflection::Joint& joint = robot.joints[j];
    const LinkMotion<Scalar>& parent = links[static_cast<std::size_t>(joint.parent)];
    const Matrix4<Scalar> P = placement<Scalar>(joint.translation, joint.rotation);
    const Scalar qd = motion.qd(j);
    const Matrix4<Scalar> Q = P * joint_matrix(joint.revolute, motion.q(j));
    const Matrix4<Scalar> Qd = P * joint_matrix_derivative(joint.revolute, motion.q(j)) * qd;
    const Matrix4<Scalar> Qdd = P * (joint_matrix_second_derivative(joint.revolute, motion.q(j)) * qd * qd +
                                     joint_matrix_derivative(joint.revolute, motion.q(j)) * motion.qdd(j));
    LinkMotion<Scalar>& child = links[static_cast<std::size_t>(joint.child)];
    child.pose = parent.pose * Q;
    child.rate = parent.rate * Q + parent.pose * Qd;
    child.second_rate = parent.second_rate * Q + Scalar(2) * parent.rate * Qd + parent.pose * Qdd;
  }
  return links;
}

// Angular velocity of a link and linear velocity of `point` (link coordinates), by the generalised velocity
// (base twist, qd): 6 x (6 + n), base coordinates.
template <class Scalar>
Matrix6X<Scalar> body_jacobian(
    const Robot& robot,
    const std::vector<Matrix4<Scalar>>& poses,
    int link,
    const Vector3<Scalar>& point) {
  const Matrix4<Scalar>& pose = poses[static_cast<std::size_t>(link)];
  const Vector3<Scalar> p = rotation_of(pose) * point + origin_of(pose);
  Matrix6X<Scalar> J = Matrix6X<Scalar>::Zero(6, 6 + robot.joints.size);
  J.template topLeftCorner<6, 6>().setIdentity();
  J.template block<3, 3>(3, 0) = -skew(p);
  for (const int j : supporting_joints(robot, link)) {
    // The z axis of the child's frame is the joint's axis, and its origin lies on it.
    const Matrix4<Scalar>& child = poses[static_cast<std::size_t>(robot.joints[j].child)];
    const Vector3<Scalar> axis = rotation_of(child).col(2);
    if (robot.joints[j].revolute) {
      J.col(6 + j).template head<3>() = axis;
      J.col(6 + j).template tail<3>() = axis.cross(p - origin_of(child));
    } else {
      J.col(6 + j).template tail<3>() = axis;
    }
  }
  return J;
}

// left_J_right: angular velocity of `right` and velocity of its origin with respect to `left`, in coordinates of
// `left`, by qd. 6 x n, all joints; those that are not between the two frames have zero columns.
template <class Scalar>
Matrix6X<Scalar> frame_jacobian(const Robot& robot, const VectorX<Scalar>& q, int left, int right) {
  const std::vector<Matrix4<Scalar>> poses = link_poses(robot, q);
  const reflection::Frame& l = robot.frames[left];
  const reflection::Frame& r = robot.frames[right];
  const auto origin = [](const reflection::Frame& f) {
    return origin_of(placement<Scalar>(f.translation, f.rotation));
  };
  // The point of the left link that lies where the origin of `right` is: both velocities are taken there.
  const Matrix4<Scalar> left_link_X_right_link =
      inverse_of(poses[static_cast<std::size_t>(l.link)]) * poses[static_cast<std::size_t>(r.link)];
  const Vector3<Scalar> point = rotation_of(left_link_X_right_link) * origin(r) + origin_of(left_link_X_right_link);
  const Matrix6X<Scalar> relative =
      body_jacobian<Scalar>(robot, poses, r.link, origin(r)) - body_jacobian<Scalar>(robot, poses, l.link, point);
  const Matrix3<Scalar> left_R_base =
      rotation_of<Scalar>(poses[static_cast<std::size_t>(l.link)] * placement<Scalar>(l.translation, l.rotation))
          .transpose();
  Matrix6X<Scalar> J(6, robot.joints.size);
  J.template topRows<3>() = left_R_base * relative.rightCols(robot.joints.size).template topRows<3>();
  J.template bottomRows<3>() = left_R_base * relative.rightCols(robot.joints.size).template bottomRows<3>();
  return J;
}

// The named columns of frame_jacobian, in that order.
template <class Scalar>
Matrix6X<Scalar> jacobian(const Robot& robot, const VectorX<Scalar>& q, const reflection::Jacobian& what) {
  const Matrix6X<Scalar> all = frame_jacobian(robot, q, what.left, what.right);
  Matrix6X<Scalar> J(6, what.column_count);
  for (int k = 0; k < what.column_count; ++k) J.col(k) = all.col(what.columns[k]);
  return J;
}

}  // namespace robcogen::reference
