#include "server/mechanics.h"

#include <cmath>
#include <limits>

#include "model/principal_moments.h"

namespace robcogen::server {
namespace {

using Rows = std::array<Vector3, 3>;

Vector3 turned(const Rows& rotation, const Vector3& v) {
  Vector3 result = {};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result[i] += rotation[i][k] * v[k];
  return result;
}

Vector3 added(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Pose composed(const Pose& a, const Pose& b) {
  Pose result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      result.rotation[i][j] = 0.0;
      for (std::size_t k = 0; k < 3; ++k) result.rotation[i][j] += a.rotation[i][k] * b.rotation[k][j];
    }
  result.translation = added(a.translation, turned(a.rotation, b.translation));
  return result;
}

// A translation along an axis, or a rotation about it.
Pose elementary(bool is_rotation, std::size_t axis, double amount) {
  Pose pose;
  if (is_rotation) {
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    pose.rotation[i][i] = pose.rotation[j][j] = std::cos(amount);
    pose.rotation[j][i] = std::sin(amount);
    pose.rotation[i][j] = -pose.rotation[j][i];
  } else {
    pose.translation[axis] = amount;
  }
  return pose;
}

std::vector<double> defaults_of(const std::vector<model::Parameter>& parameters) {
  std::vector<double> values;
  for (const model::Parameter& p : parameters)
    values.push_back(p.default_value.value_or(std::numeric_limits<double>::quiet_NaN()));
  return values;
}

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

Vector3 angles_of(const Pose& pose) {
  const Rows& r = pose.rotation;
  const double y = std::asin(std::fmin(1.0, std::fmax(-1.0, r[0][2])));
  // At the poles, x and z turn about the same axis; the angle is assigned to x.
  if (std::hypot(r[0][0], r[0][1]) < 1e-9) return {std::atan2(r[2][1], r[1][1]), y, 0.0};
  return {std::atan2(-r[1][2], r[2][2]), y, std::atan2(-r[0][1], r[0][0])};
}

Pose pose_of(const model::CoordinateTransform& transform, const model::RigidMotions& motions) {
  const std::vector<double> parameters = defaults_of(motions.parameters), variables(motions.variables.size());
  Pose pose;
  for (const model::PrimitiveTransform& p : transform.primitives) {
    if (!p.quaternion.empty()) continue;
    const double amount = model::evaluate(p.amount, parameters, variables);
    pose = composed(pose, elementary(p.rotation, static_cast<std::size_t>(p.axis), amount));
  }
  return pose;
}

RestingRobot::RestingRobot(const model::KinematicTree& tree)
    : tree_(tree), parameters_(defaults_of(tree.parameters)), links_(tree.links.size()) {
  const std::vector<int> order = tree.topological();
  const std::vector<double> q = tree.assembled_positions(parameters_);
  for (const int j : order) {
    const model::Joint& joint = tree.joints[index(j)];
    links_[index(joint.child)] = moved(placed(links_[index(joint.parent)], joint.placement), joint, q[index(j)]);
  }
  std::vector<Vector3> moments(tree.links.size(), Vector3{});  // mass times centre of mass
  carried_.resize(tree.links.size());
  for (std::size_t l = 0; l < tree.links.size(); ++l) {
    if (!tree.links[l].inertia) continue;
    const double m = mass(static_cast<int>(l));
    const Vector3 c = added(links_[l].translation, turned(links_[l].rotation, com(static_cast<int>(l))));
    carried_[l].mass = m;
    if (m != 0.0) moments[l] = {m * c[0], m * c[1], m * c[2]};
  }
  for (auto j = order.rbegin(); j != order.rend(); ++j) {
    const model::Joint& joint = tree.joints[index(*j)];
    carried_[index(joint.parent)].mass += carried_[index(joint.child)].mass;
    moments[index(joint.parent)] = added(moments[index(joint.parent)], moments[index(joint.child)]);
  }
  for (std::size_t l = 0; l < carried_.size(); ++l)
    for (std::size_t i = 0; i < 3; ++i) carried_[l].com[i] = moments[l][i] / carried_[l].mass;
}

double RestingRobot::value(const model::Quantity& q) const {
  return model::evaluate(q, parameters_);
}

Pose RestingRobot::placed(const Pose& parent, const model::Placement& placement) const {
  Pose local;
  const auto rotation = model::rotation_matrix(placement);
  for (std::size_t i = 0; i < 3; ++i) {
    local.translation[i] = value(placement.translation[i]);
    for (std::size_t j = 0; j < 3; ++j) local.rotation[i][j] = value(rotation[i][j]);
  }
  return composed(parent, local);
}

Pose RestingRobot::moved(const Pose& frame, const model::Joint& joint, double q) const {
  if (q == 0.0) return frame;
  Pose motion = elementary(model::turns(joint.type), 2, q);
  motion.translation[2] = value(model::slide_of(joint)) * q;
  return composed(frame, motion);
}

Pose RestingRobot::frame(const model::Frame& frame) const {
  switch (frame.kind) {
    case model::Frame::Kind::link:
      return link(frame.index);
    case model::Frame::Kind::joint: {
      const model::Joint& joint = tree_.joints[index(frame.index)];
      return placed(link(joint.parent), joint.placement);
    }
    case model::Frame::Kind::user:
      return placed(link(tree_.user_frames[index(frame.index)].link), tree_.user_frames[index(frame.index)].placement);
  }
  return {};
}

double RestingRobot::mass(int link) const {
  const auto& inertia = tree_.links[index(link)].inertia;
  return inertia ? value(inertia->mass) : 0.0;
}

Vector3 RestingRobot::com(int link) const {
  const auto& given = tree_.links[index(link)].inertia;
  if (!given) return {};
  const model::RigidBodyInertia inertia = model::in_link_frame(*given);
  const double m = value(inertia.mass);
  Vector3 com;
  for (std::size_t i = 0; i < 3; ++i) com[i] = value(inertia.first_moment[i]) / m;
  return com;
}

Vector3 RestingRobot::principal_moments(int link) const {
  const auto& given = tree_.links[index(link)].inertia;
  if (!given) return {};
  const model::RigidBodyInertia i = model::in_link_frame(*given);
  const Vector3 c = com(link);
  const double m = value(i.mass), xy = -value(i.ixy), xz = -value(i.ixz), yz = -value(i.iyz);
  model::SymmetricMatrix tensor = {{{value(i.ixx), xy, xz}, {xy, value(i.iyy), yz}, {xz, yz, value(i.izz)}}};
  const double square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) tensor[j][k] -= m * ((j == k ? square : 0.0) - c[j] * c[k]);
  for (const Vector3& row : tensor)
    for (const double element : row)
      if (!std::isfinite(element)) return {NAN, NAN, NAN};
  return model::principal_moments(tensor);
}

Vector3 RestingRobot::axis(int j) const {
  const model::Joint& joint = tree_.joints[index(j)];
  const Pose pose = placed(link(joint.parent), joint.placement);
  return {pose.rotation[0][2], pose.rotation[1][2], pose.rotation[2][2]};
}

}  // namespace robcogen::server
