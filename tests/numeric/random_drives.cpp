#include "random_drives.h"

#include <cmath>

#include "dice.h"
#include "rewritten_robot.h"
#include "support/index.h"

namespace robcogen::numeric {

using model::Drive;
using model::KinematicTree;
using model::Quantity;
using model::Rotor;

namespace {

// Returns an axis of any length.
std::array<double, 3> random_axis(Dice& dice) {
  std::array<double, 3> axis{};
  if (dice.chance(0.4)) {
    axis[at(dice.below(3))] = dice.between(0.2, 3) * dice.sign();
    return axis;
  }
  for (double& component : axis) component = dice.between(-1, 1);
  return axis;
}

double length_of(const std::array<double, 3>& v) {
  return std::hypot(v[0], v[1], v[2]);
}

// Returns often the joint's parent or a link between it and the base, sometimes any link.
int random_carrier(const KinematicTree& robot, const model::Joint& joint, Dice& dice) {
  if (dice.chance(0.25)) return dice.below(static_cast<int>(robot.links.size()));
  int carrier = joint.parent;
  while (carrier > 0 && dice.chance(0.3)) carrier = robot.joints[at(robot.links[at(carrier)].parent_joint)].parent;
  return carrier;
}

// Adds the spin inertia to the link that carries the rotor; false if that link has no inertia in its own frame.
bool add_to_carrier(model::Link& carrier, const Rotor& rotor, const std::array<double, 3>& axis) {
  if (!carrier.inertia || carrier.inertia->reference) return false;
  model::Inertia& inertia = *carrier.inertia;
  const double J = model::evaluate(rotor.inertia), square = length_of(axis) * length_of(axis);
  const auto share = [&](std::size_t i, std::size_t k) { return Quantity(J * axis[i] * axis[k] / square); };
  inertia.ixx = inertia.ixx + share(0, 0);
  inertia.iyy = inertia.iyy + share(1, 1);
  inertia.izz = inertia.izz + share(2, 2);
  inertia.ixy = inertia.ixy - share(0, 1);
  inertia.ixz = inertia.ixz - share(0, 2);
  inertia.iyz = inertia.iyz - share(1, 2);
  return true;
}

void add_random_rotor(KinematicTree& robot, model::Joint& joint, Dice& dice) {
  Rotor rotor;
  rotor.inertia = Quantity(dice.between(1e-3, 2e-2));
  rotor.ratio = Quantity(dice.between(1, 10) * dice.sign());
  rotor.carrier = random_carrier(robot, joint, dice);
  const bool is_own = rotor.carrier == joint.parent && dice.chance(0.4);
  const std::array<double, 3> axis = random_axis(dice);
  if (!is_own) rotor.axis = {Quantity(axis[0]), Quantity(axis[1]), Quantity(axis[2])};
  std::array<double, 3> on_carrier = axis;
  if (is_own) {
    const auto R = model::rotation_matrix(joint.placement);
    for (std::size_t i = 0; i < 3; ++i) on_carrier[i] = model::evaluate(R[i][2]);
  }
  const bool is_fixed = rotor.carrier == 0 && !robot.floating_base;
  if (is_fixed || add_to_carrier(robot.links[at(rotor.carrier)], rotor, on_carrier)) joint.drive.rotor = rotor;
}

// Tendons over a few joints each, which may be coupled or on different branches.
void add_random_tendons(KinematicTree& robot, Dice& dice) {
  const int count = 1 + dice.below(3);
  for (int k = 0; k < count; ++k) {
    model::Tendon tendon;
    tendon.name = "tendon" + std::to_string(k);
    if (dice.chance(0.8)) tendon.stiffness = Quantity(dice.between(1, 50));
    if (dice.chance(0.6)) tendon.damping = Quantity(dice.between(0.01, 2));
    if (dice.chance(0.5)) tendon.rest = Quantity(dice.between(-1, 1));
    for (std::size_t j = 0; j < robot.joints.size(); ++j)
      if (robot.joints[j].spherical.empty() && dice.chance(0.4))
        tendon.terms.push_back({static_cast<int>(j), Quantity(dice.chance(0.3) ? dice.sign() : dice.between(-2, 2))});
    if (!tendon.terms.empty()) robot.tendons.push_back(std::move(tendon));
  }
}

}  // namespace

KinematicTree with_random_drives(KinematicTree robot, std::uint64_t seed) {
  Dice dice(seed + 0x2545f4914f6cdd1d);
  const auto maybe = [&](double low, double high) {
    return dice.chance(0.5) ? Quantity(dice.between(low, high)) : Quantity();
  };
  for (model::Joint& joint : robot.joints) {
    Drive& drive = joint.drive;
    drive.damping = maybe(0.01, 2);
    drive.armature = maybe(0.01, 1);
    drive.friction = maybe(0.01, 2);
    if (!drive.friction.is_zero()) drive.friction_velocity = maybe(0.001, 0.1);
    drive.stiffness = maybe(0.1, 50);
    if (!drive.stiffness.is_zero()) drive.rest = maybe(-1, 1);
    if (dice.chance(0.5)) add_random_rotor(robot, joint, dice);
  }
  if (dice.chance(0.3)) add_random_tendons(robot, dice);
  return robot;
}

RotorBodies with_rotor_bodies(const KinematicTree& robot, std::uint64_t seed) {
  Dice dice(seed + 0x14057b7ef767814f);
  RotorBodies result{robot, robot, {}, {}};
  KinematicTree& full = result.with_bodies;
  std::vector<Rotor> rotors;
  for (int j = 0; j < robot.dof(); ++j) {
    if (!dice.chance(0.7)) continue;
    const std::string number = std::to_string(j);
    const int carrier = random_carrier(robot, robot.joints[at(j)], dice);
    // The rotor's axis is z of its frame, which is rotated about x and y of the carrier.
    model::Joint spindle;
    spindle.name = "spindle" + number;
    for (Quantity& t : spindle.placement.translation) t = Quantity(dice.between(-0.3, 0.3));
    const double a = dice.chance(0.4) ? 0.0 : dice.between(-3, 3), b = dice.chance(0.4) ? 0.0 : dice.between(-3, 3);
    spindle.placement.rotation = {Quantity(a), Quantity(b), Quantity(dice.between(-3, 3))};
    spindle.parent = carrier;
    spindle.child = static_cast<int>(full.links.size());
    const double mass = dice.between(0.1, 2), transverse = dice.between(0.005, 0.02), spin = dice.between(1e-3, 8e-3);
    const double offset = dice.between(-0.1, 0.1), moment = transverse + mass * offset * offset;
    model::Inertia body;
    body.mass = Quantity(mass);
    body.com[2] = Quantity(offset);
    body.ixx = body.iyy = Quantity(moment);
    body.izz = Quantity(spin);
    full.links.push_back({"rotor" + number, body, full.dof(), {}, {}});
    full.links[at(carrier)].child_joints.push_back(full.dof());
    full.joints.push_back(spindle);
    result.driven.push_back(j);
    result.ratios.push_back(dice.between(1, 10) * dice.sign());
    rotors.push_back(
        {Quantity(spin), Quantity(result.ratios.back()),
         std::array{Quantity(std::sin(b)), Quantity(-std::sin(a) * std::cos(b)), Quantity(std::cos(a) * std::cos(b))},
         carrier});
  }
  result.with_rotors = full;
  for (std::size_t r = rotors.size(); r-- > 0;)
    result.with_rotors = with_locked_joint(result.with_rotors, robot.dof() + static_cast<int>(r), 0.0);
  for (std::size_t r = 0; r < rotors.size(); ++r)
    result.with_rotors.joints[at(result.driven[r])].drive.rotor = rotors[r];
  return result;
}

}  // namespace robcogen::numeric
