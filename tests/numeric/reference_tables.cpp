#include "reference_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robcogen/reference/algebra.h"

namespace robcogen::numeric {
namespace {

using Real = long double;
using reference::Matrix;
using reference::Triple;
using reference::Vector;

Triple values(const std::array<model::Quantity, 3>& v, std::span<const double> parameters) {
  return {model::evaluate(v[0], parameters), model::evaluate(v[1], parameters), model::evaluate(v[2], parameters)};
}

// The integral of r r' dm about the origin; the inertia tensor follows from its trace and elements.
Matrix<Real> second_moments(const model::Inertia& inertia, std::span<const double> parameters) {
  const auto value = [&](const model::Quantity& q) { return static_cast<Real>(model::evaluate(q, parameters)); };
  const Real xx = value(inertia.ixx), yy = value(inertia.iyy), zz = value(inertia.izz);
  Matrix<Real> m(3, 3);
  m(0, 0) = (yy + zz - xx) / 2;
  m(1, 1) = (xx + zz - yy) / 2;
  m(2, 2) = (xx + yy - zz) / 2;
  m(0, 1) = m(1, 0) = value(inertia.ixy);
  m(0, 2) = m(2, 0) = value(inertia.ixz);
  m(1, 2) = m(2, 1) = value(inertia.iyz);
  return m;
}

reference::Tables::Body body(const model::Inertia& inertia, std::span<const double> parameters) {
  const Real mass = static_cast<Real>(model::evaluate(inertia.mass, parameters));
  const Triple com = values(inertia.com, parameters);
  Vector<Real> c{com[0], com[1], com[2]};
  Matrix<Real> moments = second_moments(inertia, parameters);
  if (inertia.reference) {
    // r = t + R s, with s in the user frame: substitute in the integrals of r dm and r r' dm.
    const Triple t = values(inertia.reference->translation, parameters);
    const Triple r = values(inertia.reference->rotation, parameters);
    const double translation[3] = {t[0], t[1], t[2]};
    const double rotation[3] = {r[0], r[1], r[2]};
    const Matrix<Real> pose = reference::placement<Real>(translation, rotation);
    const Matrix<Real> R = reference::rotation_of(pose);
    const Vector<Real> p = reference::origin_of(pose);
    const Matrix<Real> cross = p * transpose(R * c);
    moments = R * moments * transpose(R) + mass * (cross + transpose(cross) + p * transpose(p));
    c = p + R * c;
  }
  reference::Tables::Body result;
  result.mass = static_cast<double>(mass);
  const Real trace = moments(0, 0) + moments(1, 1) + moments(2, 2);
  for (int k = 0; k < 3; ++k) {
    result.com[static_cast<std::size_t>(k)] = static_cast<double>(c(k));
    result.inertia[static_cast<std::size_t>(k)] = static_cast<double>(trace - moments(k, k));
  }
  result.inertia[3] = static_cast<double>(moments(0, 1));
  result.inertia[4] = static_cast<double>(moments(0, 2));
  result.inertia[5] = static_cast<double>(moments(1, 2));
  return result;
}

robcogen::JointType type_of(model::JointType type) {
  switch (type) {
    case model::JointType::revolute:
      break;
    case model::JointType::prismatic:
      return robcogen::JointType::prismatic;
    case model::JointType::helical:
      return robcogen::JointType::helical;
    case model::JointType::spherical:
      return robcogen::JointType::spherical;
  }
  return robcogen::JointType::revolute;
}

// Returns the rotor axis in axes of the carrier, with unit length.
Triple axis_of(const model::Rotor& rotor, const model::Joint& joint, std::span<const double> parameters) {
  if (!rotor.axis) {
    const Triple angles = values(joint.placement.rotation, parameters);
    const double rotation[] = {angles[0], angles[1], angles[2]}, nowhere[] = {0, 0, 0};
    const Matrix<double> R = reference::rotation_of(reference::placement<double>(nowhere, rotation));
    return {R(0, 2), R(1, 2), R(2, 2)};
  }
  Triple axis = values(*rotor.axis, parameters);
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  for (double& component : axis) component /= length;
  return axis;
}

JointDrive drive_of(const model::Joint& joint, std::span<const double> parameters) {
  const model::Drive& drive = joint.drive;
  const auto value = [&](const model::Quantity& q) { return model::evaluate(q, parameters); };
  JointDrive result;
  result.damping = value(drive.damping);
  result.friction = value(drive.friction);
  result.friction_velocity = value(drive.friction_velocity);
  result.stiffness = value(drive.stiffness);
  result.rest = value(drive.rest);
  result.armature = value(drive.armature);
  if (drive.rotor) {
    result.rotor_inertia = value(drive.rotor->inertia);
    result.rotor_ratio = value(drive.rotor->ratio);
    const Triple axis = axis_of(*drive.rotor, joint, parameters);
    std::copy(axis.begin(), axis.end(), result.rotor_axis);
    result.rotor_carrier = drive.rotor->carrier;
  }
  return result;
}

}  // namespace

reference::Tables reference_tables(const model::KinematicTree& robot, std::span<const double> parameters) {
  reference::Tables tables(robot.name, robot.floating_base);
  for (const model::Link& link : robot.links)
    if (!link.is_repeated)
      tables.add_link(link.name, link.inertia ? body(*link.inertia, parameters) : reference::Tables::Body{});
  // Coupled joints come after the others, as in generated tables.
  std::vector<int> order = robot.coordinates();
  for (const model::Coupling& coupling : robot.couplings) order.push_back(coupling.joint);
  for (const int j : order) {
    const model::Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    const int first_index = robot.first_component_of(j);
    const model::Joint& first = robot.joints[static_cast<std::size_t>(first_index)];
    const int child =
        joint.spherical.empty() ? joint.child : robot.joints[static_cast<std::size_t>(first_index) + 2].child;
    tables.add_joint(
        joint.name, type_of(joint.type), first.parent, child, values(first.placement.translation, parameters),
        values(first.placement.rotation, parameters));
    const int last = tables.robot().joints.size - 1;
    tables.set_drive(last, drive_of(joint, parameters));
    tables.set_pitch(last, model::evaluate(joint.pitch, parameters));
    if (robot.coupling_of(j) == nullptr) tables.set_assembled(last, joint.assembled.value_or(0.0));
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const model::Coupling& coupling : robot.couplings) {
    std::vector<double> factors(order.size() - robot.couplings.size());
    for (const model::Coupling::Term& term : coupling.terms)
      factors[static_cast<std::size_t>(std::find(order.begin(), order.end(), term.joint) - order.begin())] =
          coupling.is_linear() ? model::evaluate(term.factor, parameters) : kNone;
    if (coupling.is_linear())
      tables.add_coupling(factors, model::evaluate(coupling.offset, parameters));
    else
      tables.add_coupling(factors, kNone, model::evaluate(coupling.offset));
  }
  for (const int follower : robot.followers_in_q())
    tables.add_follower(
        static_cast<int>(std::find(order.begin(), order.end(), follower) - order.begin()),
        model::evaluate(robot.coupling_of(follower)->offset));
  for (const model::Tendon& tendon : robot.tendons) {
    std::vector<double> factors(order.size());
    for (const model::Tendon::Term& term : tendon.terms)
      factors[static_cast<std::size_t>(std::find(order.begin(), order.end(), term.joint) - order.begin())] =
          model::evaluate(term.factor, parameters);
    const auto value = [&](const model::Quantity& q) { return model::evaluate(q, parameters); };
    tables.add_tendon(tendon.name, factors, value(tendon.stiffness), value(tendon.damping), value(tendon.rest));
  }
  for (const model::Frame& frame : robot.frames()) {
    const model::Placement placement = robot.placement_of(frame);
    tables.add_frame(
        frame.name, robot.link_of(frame), values(placement.translation, parameters),
        values(placement.rotation, parameters));
  }
  for (const model::LoopJoint& loop : robot.loops) {
    const auto type = static_cast<reflection::LoopType>(loop.type);
    const auto index = [&](std::size_t end) { return frame_index(robot, *robot.find_frame(loop.ends[end].frame)); };
    tables.add_loop(loop.name, type, index(0), index(1), model::evaluate(loop.length, parameters));
  }
  return tables;
}

int frame_index(const model::KinematicTree& robot, const model::Frame& frame) {
  const std::vector<model::Frame> frames = robot.frames();
  const auto found =
      std::find_if(frames.begin(), frames.end(), [&](const model::Frame& f) { return f.name == frame.name; });
  return static_cast<int>(found - frames.begin());
}

}  // namespace robcogen::numeric
