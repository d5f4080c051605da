// Poses, velocities and Jacobians of an articulated robot by products of 4 x 4 matrices, all in base coordinates.
//
// Velocities and accelerations come from the product rule on those matrices (Uicker 1965), so that no formula for
// Coriolis or centripetal terms is needed. For a floating base, "at rest" means at rest in the inertial frame that
// coincides with the base frame at the instant considered.
#pragma once

#include "robcogen/reference/algebra.h"
#include "robcogen/reflection.h"

namespace robcogen::reference {

using reflection::Robot;

// How coupled joints follow the others, dq/dy: a row per joint, a column per element of q.
template <class Scalar>
Matrix<Scalar> coupling_matrix(const Robot& robot) {
  Matrix<Scalar> G(robot.joints.size, robot.dof());
  G.set_block(0, 0, Matrix<Scalar>::identity(robot.dof()));
  for (int k = 0; k < robot.couplings.size; ++k)
    for (int c = 0; c < robot.dof(); ++c) G(robot.dof() + k, c) = Scalar(robot.couplings[k].factors[c]);
  return G;
}

// An element of q that moves a joint, and by what factor: a nonzero element of the joint's row of that matrix.
struct Mover {
  int coordinate;
  double factor;
};

inline std::vector<Mover> movers_of(const Robot& robot, int joint) {
  if (joint < robot.dof()) return {{joint, 1}};
  std::vector<Mover> movers;
  for (int c = 0; c < robot.dof(); ++c) {
    const double factor = robot.couplings[joint - robot.dof()].factors[c];
    if (factor != 0) movers.push_back({c, factor});
  }
  return movers;
}

// True if joints follow in proportions that change: through loops other than parallelograms (loops.h).
inline bool follows_through_loops(const Robot& robot) {
  return std::any_of(robot.couplings.begin(), robot.couplings.end(), [](const reflection::Coupling& coupling) {
    return std::isnan(coupling.offset);
  });
}

// Velocities or accelerations of all joints.
template <class Scalar>
Vector<Scalar> joint_rates(const Robot& robot, const Vector<Scalar>& rates) {
  Vector<Scalar> all(robot.joints.size);
  for (int j = 0; j < robot.joints.size; ++j)
    for (const Mover& mover : movers_of(robot, j)) all(j) += Scalar(mover.factor) * rates(mover.coordinate);
  return all;
}

// Positions of all joints; zero for spherical joints, whose positions are quaternions.
template <class Scalar>
Vector<Scalar> joint_positions(const Robot& robot, const Vector<Scalar>& q) {
  Vector<Scalar> numbers(robot.dof());
  for (int j = 0; j < robot.dof(); ++j)
    if (robot.joints[j].type != JointType::spherical) numbers(j) = q(robot.position_of(j));
  Vector<Scalar> all = joint_rates(robot, numbers);
  for (int k = 0; k < robot.couplings.size; ++k) all(robot.dof() + k) += Scalar(robot.couplings[k].offset);
  return all;
}

// Base velocity and acceleration are a twist and a spatial acceleration in base coordinates, about the base origin;
// gravity is not included. Both are zero for a fixed base.
template <class Scalar>
struct Motion {
  Vector<Scalar> q, qd, qdd;
  Vector<Scalar> base_velocity = Vector<Scalar>(6);
  Vector<Scalar> base_acceleration = Vector<Scalar>(6);
  // For each joint, the acceleration that loops add at these velocities (loops.h); or empty.
  Vector<Scalar> of_loops = {};
};

// Accelerations of all joints.
template <class Scalar>
Vector<Scalar> joint_accelerations(const Robot& robot, const Motion<Scalar>& motion) {
  const Vector<Scalar> accelerations = joint_rates(robot, motion.qdd);
  return motion.of_loops.empty() ? accelerations : accelerations + motion.of_loops;
}

// A motion at rest in the configuration q.
template <class Scalar>
Motion<Scalar> at_rest(const Robot& robot, const Vector<Scalar>& q) {
  return {q, Vector<Scalar>(robot.dof()), Vector<Scalar>(robot.dof())};
}
// For a robot without spherical joints.
template <class Scalar>
Motion<Scalar> at_rest(const Vector<Scalar>& q) {
  return {q, Vector<Scalar>(q.rows()), Vector<Scalar>(q.rows())};
}

// The positions after all joints have moved by `way`, which has an element per velocity: a spherical joint rotates by
// the vector `way` about axes of its child. The scalar may be complex.
template <class Scalar>
Vector<Scalar> moved(const Robot& robot, const Vector<Scalar>& q, const Vector<Scalar>& way) {
  Vector<Scalar> result = q;
  for (int j = 0; j < robot.dof(); ++j) {
    if (robot.is_follower(j)) continue;
    const int k = robot.position_of(j);
    if (robot.joints[j].type != JointType::spherical) {
      result(k) += way(j);
      continue;
    }
    const Vector<Scalar> turn{way(j) / Scalar(2), way(j + 1) / Scalar(2), way(j + 2) / Scalar(2)};
    const Scalar square = dot(turn, turn);
    Scalar cosine = Scalar(1) - square / Scalar(2) + square * square / Scalar(24);
    Scalar quotient = Scalar(1) - square / Scalar(6) + square * square / Scalar(120);
    constexpr double kSmall = 1e-7;
    if (std::abs(square) > kSmall) {
      cosine = std::cos(std::sqrt(square));
      quotient = std::sin(std::sqrt(square)) / std::sqrt(square);
    }
    const Scalar w = q(k - 1);
    const Vector<Scalar> v{q(k), q(k + 1), q(k + 2)}, sine = quotient * turn;
    const Vector<Scalar> vector = cosine * v + w * sine + cross(v, sine);
    result(k - 1) = w * cosine - dot(v, sine);
    for (int i = 0; i < 3; ++i) result(k + i) = vector(i);
  }
  return result;
}

// Joints sorted so that each comes after the joint that supports its parent link; of a spherical joint, only the first
// component.
inline std::vector<int> outward_order(const Robot& robot) {
  std::vector<int> joints;
  std::vector<int> links{0};
  for (std::size_t k = 0; k < links.size(); ++k) {
    for (int j = 0; j < robot.joints.size; ++j) {
      if (robot.joints[j].parent != links[k] || robot.is_follower(j)) continue;
      joints.push_back(j);
      links.push_back(robot.joints[j].child);
    }
  }
  assert(static_cast<int>(links.size()) == robot.links.size && "the joints do not form a tree");
  return joints;
}

// The joints between a link and the base, from the link inwards.
inline std::vector<int> supporting_joints(const Robot& robot, int link) {
  std::vector<int> joints;
  for (int j = robot.links[link].parent_joint; j >= 0; j = robot.links[robot.joints[j].parent].parent_joint) {
    const int components = robot.joints[j].type == JointType::spherical ? 3 : 1;
    for (int k = components - 1; k >= 0; --k) joints.push_back(j + k);
  }
  return joints;
}

// The distance by which a joint slides per unit of its position.
template <class Scalar>
Scalar slide_per_unit(const reflection::Joint& joint) {
  if (joint.type == JointType::helical) return Scalar(joint.pitch);
  return Scalar(joint.type == JointType::prismatic ? 1 : 0);
}

// The motion of a joint as a matrix of its position: Rz(q), Tz(q), or Rz(q) Tz(p q) for a screw; and its first two
// derivatives with respect to q.
template <class Scalar>
Matrix<Scalar> joint_matrix(const reflection::Joint& joint, const Scalar& q) {
  Matrix<Scalar> m = turns(joint.type) ? rotation(2, q) : Matrix<Scalar>::identity(4);
  m(2, 3) = slide_per_unit<Scalar>(joint) * q;
  return m;
}

template <class Scalar>
Matrix<Scalar> joint_matrix_derivative(const reflection::Joint& joint, const Scalar& q) {
  Matrix<Scalar> m(4, 4);
  if (turns(joint.type)) {
    m(0, 0) = m(1, 1) = -std::sin(q);
    m(0, 1) = -std::cos(q);
    m(1, 0) = std::cos(q);
  }
  m(2, 3) = slide_per_unit<Scalar>(joint);
  return m;
}

template <class Scalar>
Matrix<Scalar> joint_matrix_second_derivative(const reflection::Joint& joint, const Scalar& q) {
  Matrix<Scalar> m(4, 4);
  if (turns(joint.type)) {
    m(0, 0) = m(1, 1) = -std::cos(q);
    m(0, 1) = std::sin(q);
    m(1, 0) = -std::sin(q);
  }
  return m;
}

// The rotation of a spherical joint, given its first component: v + 2 w u x v + 2 u x (u x v) for the quaternion (w,
// u).
template <class Scalar>
Matrix<Scalar> spherical_matrix(const Robot& robot, int joint, const Vector<Scalar>& q) {
  const int k = robot.position_of(joint);
  const Matrix<Scalar> u = skew(Vector<Scalar>{q(k), q(k + 1), q(k + 2)});
  Matrix<Scalar> m = Matrix<Scalar>::identity(4);
  m.set_block(0, 0, Matrix<Scalar>::identity(3) + Scalar(2) * q(k - 1) * u + Scalar(2) * (u * u));
  return m;
}

// How the placed frame of a joint moves: its pose as a matrix, and the first two time derivatives.
template <class Scalar>
struct JointMotion {
  Matrix<Scalar> pose, rate, second_rate;
};

// `positions`, `velocities` and `accelerations` are those of all joints.
template <class Scalar>
JointMotion<Scalar> joint_motion(
    const Robot& robot,
    int j,
    const Motion<Scalar>& motion,
    const Vector<Scalar>& positions,
    const Vector<Scalar>& velocities,
    const Vector<Scalar>& accelerations) {
  const reflection::Joint& joint = robot.joints[j];
  const Scalar q = positions(j), qd = velocities(j), qdd = accelerations(j);
  if (joint.type != JointType::spherical)
    return {
        joint_matrix(joint, q), qd * joint_matrix_derivative(joint, q),
        qd * qd * joint_matrix_second_derivative(joint, q) + qdd * joint_matrix_derivative(joint, q)};
  // In axes of the child: R' = R [w]x.
  const auto spin = [&](const Vector<Scalar>& rates) {
    Matrix<Scalar> m(4, 4);
    m.set_block(0, 0, skew(Vector<Scalar>{rates(j), rates(j + 1), rates(j + 2)}));
    return m;
  };
  const Matrix<Scalar> R = spherical_matrix(robot, j, motion.q), W = spin(velocities);
  return {R, R * W, R * (W * W + spin(accelerations))};
}

// The pose of each link in the base frame; the scalar may be complex.
template <class Scalar>
std::vector<Matrix<Scalar>> link_poses(const Robot& robot, const Vector<Scalar>& q) {
  std::vector<Matrix<Scalar>> poses(static_cast<std::size_t>(robot.links.size), Matrix<Scalar>::identity(4));
  const Vector<Scalar> positions = joint_positions(robot, q);
  for (const int j : outward_order(robot)) {
    const reflection::Joint& joint = robot.joints[j];
    const bool is_spherical = joint.type == JointType::spherical;
    poses[static_cast<std::size_t>(joint.child)] =
        poses[static_cast<std::size_t>(joint.parent)] * placement<Scalar>(joint.translation, joint.rotation) *
        (is_spherical ? spherical_matrix(robot, j, q) : joint_matrix(joint, positions(j)));
  }
  return poses;
}

// left_X_right as a homogeneous transform; frames are given by index.
template <class Scalar>
Matrix<Scalar> transform(const Robot& robot, const Vector<Scalar>& q, int left, int right) {
  const std::vector<Matrix<Scalar>> poses = link_poses(robot, q);
  const auto pose = [&](int frame) {
    const reflection::Frame& f = robot.frames[frame];
    return poses[static_cast<std::size_t>(f.link)] * placement<Scalar>(f.translation, f.rotation);
  };
  return inverse_of(pose(left)) * pose(right);
}

// The pose of a link in the base frame, and the first and second time derivatives of that matrix with respect to a
// frame at rest.
template <class Scalar>
struct LinkMotion {
  Matrix<Scalar> pose = Matrix<Scalar>::identity(4);
  Matrix<Scalar> rate = Matrix<Scalar>(4, 4);
  Matrix<Scalar> second_rate = Matrix<Scalar>(4, 4);

  // The rotation parts are rate = [w]x R and second_rate = ([w']x + [w]x [w]x) R.
  Vector<Scalar> angular_velocity() const { return axis_of(rotation_of(rate) * transpose(rotation_of(pose))); }
  Vector<Scalar> angular_acceleration() const {
    return axis_of(rotation_of(second_rate) * transpose(rotation_of(pose)));
  }
  // For a point fixed to the link, given in link coordinates.
  Vector<Scalar> position(const Vector<Scalar>& point) const { return apply(pose, point); }
  Vector<Scalar> velocity(const Vector<Scalar>& point) const { return apply(rate, point); }
  Vector<Scalar> acceleration(const Vector<Scalar>& point) const { return apply(second_rate, point); }

 private:
  static Vector<Scalar> apply(const Matrix<Scalar>& m, const Vector<Scalar>& point) {
    return rotation_of(m) * point + origin_of(m);
  }
};

template <class Scalar>
std::vector<LinkMotion<Scalar>> link_motions(const Robot& robot, const Motion<Scalar>& motion) {
  std::vector<LinkMotion<Scalar>> links(static_cast<std::size_t>(robot.links.size));

  const Matrix<Scalar> spin = skew(motion.base_velocity.head(3));
  const Vector<Scalar> v = motion.base_velocity.tail(3);
  LinkMotion<Scalar>& base = links[0];
  base.rate.set_block(0, 0, spin);
  base.rate.set_block(0, 3, v);
  // The spatial acceleration is that of the body-fixed point passing a point at rest; the acceleration of the origin
  // itself is larger by w x v.
  base.second_rate.set_block(0, 0, skew(motion.base_acceleration.head(3)) + spin * spin);
  base.second_rate.set_block(0, 3, motion.base_acceleration.tail(3) + spin * v);

  const Vector<Scalar> positions = joint_positions(robot, motion.q);
  const Vector<Scalar> velocities = joint_rates(robot, motion.qd), accelerations = joint_accelerations(robot, motion);
  for (const int j : outward_order(robot)) {
    const reflection::Joint& joint = robot.joints[j];
    const LinkMotion<Scalar>& parent = links[static_cast<std::size_t>(joint.parent)];
    const Matrix<Scalar> P = placement<Scalar>(joint.translation, joint.rotation);
    const JointMotion<Scalar> own = joint_motion(robot, j, motion, positions, velocities, accelerations);
    const Matrix<Scalar> Q = P * own.pose, Q_rate = P * own.rate, Q_second_rate = P * own.second_rate;
    LinkMotion<Scalar>& child = links[static_cast<std::size_t>(joint.child)];
    child.pose = parent.pose * Q;
    child.rate = parent.rate * Q + parent.pose * Q_rate;
    child.second_rate = parent.second_rate * Q + Scalar(2) * (parent.rate * Q_rate) + parent.pose * Q_second_rate;
  }
  return links;
}

// Angular velocity of a link and linear velocity of `point` (link coordinates), by the generalised velocity
// (base twist, qd): 6 x (6 + n), base coordinates.
template <class Scalar>
Matrix<Scalar> body_jacobian(
    const Robot& robot,
    const std::vector<Matrix<Scalar>>& poses,
    int link,
    const Vector<Scalar>& point) {
  const Matrix<Scalar>& pose = poses[static_cast<std::size_t>(link)];
  const Vector<Scalar> p = rotation_of(pose) * point + origin_of(pose);
  Matrix<Scalar> J(6, 6 + robot.dof());
  J.set_block(0, 0, Matrix<Scalar>::identity(6));
  J.set_block(3, 0, -skew(p));
  for (const int j : supporting_joints(robot, link)) {
    // The z axis of the child's frame is the joint's axis, and its origin lies on it; a spherical joint has all three
    // axes.
    const Matrix<Scalar>& child = poses[static_cast<std::size_t>(robot.joints[j].child)];
    const Vector<Scalar> axis = child.block(0, robot.axis_of(j), 3, 1);
    const reflection::Joint& joint = robot.joints[j];
    Vector<Scalar> angular(3), linear = slide_per_unit<Scalar>(joint) * axis;
    if (turns(joint.type)) {
      angular = axis;
      linear = linear + cross(axis, p - origin_of(child));
    }
    const Vector<Scalar> column = stacked(angular, linear);
    for (const Mover& mover : movers_of(robot, j))
      for (int i = 0; i < 6; ++i) J(i, 6 + mover.coordinate) += Scalar(mover.factor) * column(i);
  }
  return J;
}

// left_J_right: angular velocity of `right` and velocity of its origin with respect to `left`, in coordinates of
// `left`, by qd. 6 x n, for all elements of q; columns of elements that do not move one frame with respect to the other
// are zero.
template <class Scalar>
Matrix<Scalar> frame_jacobian(const Robot& robot, const Vector<Scalar>& q, int left, int right) {
  const std::vector<Matrix<Scalar>> poses = link_poses(robot, q);
  const reflection::Frame& l = robot.frames[left];
  const reflection::Frame& r = robot.frames[right];
  const Matrix<Scalar>& left_link = poses[static_cast<std::size_t>(l.link)];
  const Matrix<Scalar>& right_link = poses[static_cast<std::size_t>(r.link)];
  const Vector<Scalar> point = origin_of(placement<Scalar>(r.translation, r.rotation));
  // Both velocities are taken at one point: the point of the left link that is at the origin of `right`.
  const Matrix<Scalar> left_link_X_right_link = inverse_of(left_link) * right_link;
  const Vector<Scalar> same_point = rotation_of(left_link_X_right_link) * point + origin_of(left_link_X_right_link);
  const Matrix<Scalar> relative =
      body_jacobian(robot, poses, r.link, point) - body_jacobian(robot, poses, l.link, same_point);
  const Matrix<Scalar> left_R_base = transpose(rotation_of(left_link * placement<Scalar>(l.translation, l.rotation)));
  const int n = robot.dof();
  return stacked(left_R_base * relative.block(0, 6, 3, n), left_R_base * relative.block(3, 6, 3, n));
}

// The columns of frame_jacobian that `what` names, in that order.
template <class Scalar>
Matrix<Scalar> jacobian(const Robot& robot, const Vector<Scalar>& q, const reflection::Jacobian& what) {
  const Matrix<Scalar> all = frame_jacobian(robot, q, what.left, what.right);
  Matrix<Scalar> J(6, what.column_count);
  for (int k = 0; k < what.column_count; ++k) J.set_block(0, k, all.col(what.columns[k]));
  return J;
}

}  // namespace robcogen::reference
