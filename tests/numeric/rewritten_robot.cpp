#include "rewritten_robot.h"

#include <algorithm>
#include <cmath>

#include "at.h"
#include "robcogen/reference/kinematics.h"

namespace robcogen::numeric {
namespace {

using model::Inertia;
using model::Joint;
using model::KinematicTree;
using model::Link;
using model::Placement;
using model::Quantity;
using model::UserFrame;
using reference::Matrix;
using reference::Vector;
using Real = long double;

Quantity quantity(Real value) {
  return Quantity(static_cast<double>(value));
}

// The mass, and the first and second moments about the origin: the integrals of r dm and r r' dm. Moments of bodies
// add.
struct Moments {
  Real mass = 0;
  Vector<Real> first = Vector<Real>(3);
  Matrix<Real> second = Matrix<Real>(3, 3);
};

// The same body in coordinates A, given A_X_B.
Moments moved(const Pose& A_X_B, const Moments& b) {
  const Matrix<Real> R = reference::rotation_of(A_X_B);
  const Vector<Real> p = reference::origin_of(A_X_B);
  const Matrix<Real> mixed = p * transpose(R * b.first);
  return {
      b.mass, b.mass * p + R * b.first,
      R * b.second * transpose(R) + mixed + transpose(mixed) + b.mass * (p * transpose(p))};
}

Moments moments_of(const Inertia& inertia) {
  const auto value = [](const Quantity& q) { return static_cast<Real>(model::evaluate(q)); };
  const Real xx = value(inertia.ixx), yy = value(inertia.iyy), zz = value(inertia.izz);
  Moments m;
  m.mass = value(inertia.mass);
  for (int k = 0; k < 3; ++k) m.first(k) = m.mass * value(inertia.com[at(k)]);
  m.second(0, 0) = (yy + zz - xx) / 2;
  m.second(1, 1) = (xx + zz - yy) / 2;
  m.second(2, 2) = (xx + yy - zz) / 2;
  m.second(0, 1) = m.second(1, 0) = value(inertia.ixy);
  m.second(0, 2) = m.second(2, 0) = value(inertia.ixz);
  m.second(1, 2) = m.second(2, 1) = value(inertia.iyz);
  return inertia.reference ? moved(pose_of(*inertia.reference), m) : m;
}

Inertia inertia_of(const Moments& m) {
  Inertia inertia;
  inertia.mass = quantity(m.mass);
  for (int k = 0; k < 3; ++k) inertia.com[at(k)] = quantity(m.first(k) / m.mass);
  inertia.ixx = quantity(m.second(1, 1) + m.second(2, 2));
  inertia.iyy = quantity(m.second(0, 0) + m.second(2, 2));
  inertia.izz = quantity(m.second(0, 0) + m.second(1, 1));
  inertia.ixy = quantity(m.second(0, 1));
  inertia.ixz = quantity(m.second(0, 2));
  inertia.iyz = quantity(m.second(1, 2));
  return inertia;
}

void move_placement(const Pose& new_X_old, Placement& placement) {
  placement = placement_of(new_X_old * pose_of(placement));
}

// Moves everything that is given in the coordinates of a link.
void move_contents(KinematicTree& robot, int link, const Pose& new_X_old) {
  Link& owner = robot.links[at(link)];
  if (owner.inertia) owner.inertia = inertia_of(moved(new_X_old, moments_of(*owner.inertia)));
  for (const int j : owner.child_joints) move_placement(new_X_old, robot.joints[at(j)].placement);
  for (UserFrame& frame : robot.user_frames) {
    if (frame.link == link) move_placement(new_X_old, frame.placement);
  }
}

}  // namespace

Pose pose_of(const Placement& placement) {
  const auto [tx, ty, tz] = placement.translation;
  const auto [rx, ry, rz] = placement.rotation;
  const double t[3] = {model::evaluate(tx), model::evaluate(ty), model::evaluate(tz)};
  const double r[3] = {model::evaluate(rx), model::evaluate(ry), model::evaluate(rz)};
  return reference::placement<Real>(t, r);
}

Placement placement_of(const Pose& pose) {
  // R = Rx(a) Ry(b) Rz(c). Where b is a right angle, a and c turn about one axis and a is free.
  const Real horizontal = std::hypot(pose(1, 2), pose(2, 2));
  const Real a = horizontal < 1e-15L ? 0 : std::atan2(-pose(1, 2), pose(2, 2));
  const Real b = std::atan2(pose(0, 2), horizontal);
  const Pose rest = transpose(reference::rotation(0, a) * reference::rotation(1, b)) * pose;
  const Real c = std::atan2(rest(1, 0), rest(0, 0));
  return {{quantity(pose(0, 3)), quantity(pose(1, 3)), quantity(pose(2, 3))}, {quantity(a), quantity(b), quantity(c)}};
}

KinematicTree reordered(
    const KinematicTree& robot,
    const std::vector<int>& link_order,
    const std::vector<int>& joint_order) {
  const auto places = [](const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) place[at(order[k])] = static_cast<int>(k);
    return place;
  };
  const std::vector<int> link_place = places(link_order), joint_place = places(joint_order);
  KinematicTree result = robot;
  for (std::size_t k = 0; k < link_order.size(); ++k) {
    Link& link = result.links[k] = robot.links[at(link_order[k])];
    if (link.parent_joint >= 0) link.parent_joint = joint_place[at(link.parent_joint)];
    for (int& joint : link.child_joints) joint = joint_place[at(joint)];
  }
  for (std::size_t k = 0; k < joint_order.size(); ++k) {
    Joint& joint = result.joints[k] = robot.joints[at(joint_order[k])];
    joint.parent = link_place[at(joint.parent)];
    joint.child = link_place[at(joint.child)];
    if (joint.drive.rotor) joint.drive.rotor->carrier = link_place[at(joint.drive.rotor->carrier)];
  }
  for (model::Tendon& tendon : result.tendons)
    for (model::Tendon::Term& term : tendon.terms) term.joint = joint_place[at(term.joint)];
  for (UserFrame& frame : result.user_frames) frame.link = link_place[at(frame.link)];
  return result;
}

KinematicTree renamed(const KinematicTree& robot) {
  KinematicTree result = robot;
  for (Link& link : result.links) link.name = "x_" + link.name;
  for (Joint& joint : result.joints) joint.name = "another_" + joint.name;
  for (UserFrame& frame : result.user_frames) frame.name += "_too";
  return result;
}

Reframed reframed(const KinematicTree& robot) {
  Reframed result{robot, {}};
  for (int i = 0; i < static_cast<int>(robot.links.size()); ++i) {
    const int joint = robot.links[at(i)].parent_joint;
    Pose old_X_new = Pose::identity(4);
    if (joint >= 0) {
      // A displacement along and about the axis commutes with the motion of the joint.
      const Real slide = 0.1L * static_cast<Real>(i % 5) - 0.2L, turn = 0.7L * static_cast<Real>(i);
      old_X_new = reference::translation(Real(0), Real(0), slide) * reference::rotation(2, turn);
      Placement& placement = result.robot.joints[at(joint)].placement;
      placement = placement_of(pose_of(placement) * old_X_new);
    }
    result.new_X_old.push_back(reference::inverse_of(old_X_new));
    move_contents(result.robot, i, result.new_X_old.back());
  }
  return result;
}

KinematicTree mirrored(const KinematicTree& robot) {
  // With M = diag(1, -1, 1), M R M reverses rotations about x and z, and keeps those about y.
  const auto mirror = [](Placement& p) {
    p.translation[1] = -p.translation[1];
    p.rotation[0] = -p.rotation[0];
    p.rotation[2] = -p.rotation[2];
  };
  KinematicTree result = robot;
  for (Joint& joint : result.joints) {
    mirror(joint.placement);
    joint.pitch = -joint.pitch;
  }
  for (UserFrame& frame : result.user_frames) mirror(frame.placement);
  for (Link& link : result.links) {
    if (!link.inertia) continue;
    link.inertia->com[1] = -link.inertia->com[1];
    link.inertia->ixy = -link.inertia->ixy;
    link.inertia->iyz = -link.inertia->iyz;
    if (link.inertia->reference) mirror(*link.inertia->reference);
  }
  return result;
}

KinematicTree with_locked_joint(const KinematicTree& robot, int joint, double position) {
  const Joint locked = robot.joints[at(joint)];
  const Real slide = static_cast<Real>(position) * static_cast<Real>(model::evaluate(slide_of(locked)));
  const Pose motion = reference::rotation(2, turns(locked.type) ? static_cast<Real>(position) : Real(0)) *
                      reference::translation(Real(0), Real(0), slide);
  const Pose parent_X_child = pose_of(locked.placement) * motion;

  KinematicTree result = robot;
  move_contents(result, locked.child, parent_X_child);
  Link& parent = result.links[at(locked.parent)];
  Link& child = result.links[at(locked.child)];
  if (child.inertia && parent.inertia) {
    const Moments a = moments_of(*parent.inertia), b = moments_of(*child.inertia);
    parent.inertia = inertia_of({a.mass + b.mass, a.first + b.first, a.second + b.second});
  } else if (child.inertia) {
    parent.inertia = child.inertia;
  }
  std::erase(parent.child_joints, joint);
  for (const int j : child.child_joints) {
    parent.child_joints.push_back(j);
    result.joints[at(j)].parent = locked.parent;
  }
  child.child_joints.clear();
  for (UserFrame& frame : result.user_frames) {
    if (frame.link == locked.child) frame.link = locked.parent;
  }

  // Close the gaps in both lists.
  const auto beyond = [](int& index, int gone) { index -= index > gone ? 1 : 0; };
  result.links.erase(result.links.begin() + locked.child);
  result.joints.erase(result.joints.begin() + joint);
  for (Link& link : result.links) {
    beyond(link.parent_joint, joint);
    for (int& j : link.child_joints) beyond(j, joint);
  }
  for (Joint& j : result.joints) {
    beyond(j.parent, locked.child);
    beyond(j.child, locked.child);
  }
  for (UserFrame& frame : result.user_frames) beyond(frame.link, locked.child);
  for (model::Tendon& tendon : result.tendons) {
    for (const model::Tendon::Term& term : tendon.terms)
      if (term.joint == joint) tendon.rest = tendon.rest - term.factor * Quantity(position);
    std::erase_if(tendon.terms, [&](const model::Tendon::Term& term) { return term.joint == joint; });
    for (model::Tendon::Term& term : tendon.terms) beyond(term.joint, joint);
  }
  return result;
}

}  // namespace robcogen::numeric
