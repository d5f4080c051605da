#include "ill_robot.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "dice.h"

namespace robcogen::numeric {
namespace {

using model::Inertia;
using model::Joint;
using model::JointType;
using model::KinematicTree;
using model::Placement;
using model::Quantity;

// Returns a value as a document writes it: as a decimal.
Quantity decimal(double value) {
  return Quantity(*Number::parse(print_double(value)));
}

double power_of_ten(int exponent) {
  return Number::parse("1e" + std::to_string(exponent))->value();
}

Quantity angle(Dice& dice) {
  constexpr std::array kPiByDigits = {3.14159, 3.1416, 3.14159265, 3.1415926535, 3.14, 3.141592653589793};
  switch (dice.below(6)) {
    case 0:
      return Quantity();
    case 1:
      return Quantity(Number::pi_multiple(dice.below(4) - 1, 2));
    case 2:  // near zero
      return decimal(dice.sign() * power_of_ten(-1 - dice.below(17)));
    case 3: {  // near a multiple of a right angle
      const double turns = 0.5 * (dice.below(4) - 1);
      return decimal(dice.sign() * turns * kPiByDigits[static_cast<std::size_t>(dice.below(6))]);
    }
    case 4:
      return decimal(std::round(dice.between(-3, 3) * 1e4) / 1e4);
    default:
      return Quantity(dice.between(-3.14, 3.14));
  }
}

Quantity length(Dice& dice, double scale) {
  if (dice.chance(0.4)) return Quantity();
  if (dice.chance(0.1)) return decimal(dice.sign() * power_of_ten(dice.chance(0.5) ? -18 : -12));
  return decimal(scale * std::round(dice.between(-0.5, 0.5) * 1e4) / 1e4);
}

Placement placement(Dice& dice, double scale) {
  Placement p;
  for (Quantity& t : p.translation) t = length(dice, scale);
  for (Quantity& r : p.rotation) r = angle(dice);
  return p;
}

// Noise of an exporter, or zero.
double crumb(Dice& dice) {
  constexpr std::array kCrumbs = {0.0, 3e-18, -3.469446951953614e-18, 1e-12, -4e-12, 0.0};
  return kCrumbs[static_cast<std::size_t>(dice.below(6))];
}

// An ellipsoid about its centre of mass, which lies on an axis of the link, in a coordinate plane, or anywhere.
Inertia body(Dice& dice, double mass, double scale) {
  std::array<double, 3> com{}, half{};
  for (double& x : com) x = dice.chance(0.5) ? crumb(dice) * scale : scale * dice.between(-0.3, 0.3);
  for (double& x : half) x = scale * dice.between(0.05, 0.3);
  const auto square = [](double x) { return x * x; };
  const auto central = [&](std::size_t i) { return mass * square(half[i]) / 5; };
  const auto second = [&](std::size_t i) { return central(i) + mass * square(com[i]); };
  Inertia result;
  result.mass = Quantity(mass);
  for (std::size_t k = 0; k < 3; ++k) result.com[k] = Quantity(com[k]);
  result.ixx = Quantity(second(1) + second(2));
  result.iyy = Quantity(second(0) + second(2));
  result.izz = Quantity(second(0) + second(1));
  const double noise = mass * square(scale);
  const auto product = [&](std::size_t i, std::size_t k) {
    return Quantity(mass * com[i] * com[k] + (dice.chance(0.3) ? crumb(dice) * noise : 0.0));
  };
  result.ixy = product(0, 1);
  result.ixz = product(0, 2);
  result.iyz = product(1, 2);
  return result;
}

// The joint axis as seen from its parent or child, an axis of the carrier, or any axis; with noise and not normalised.
std::array<double, 3> noisy_axis(Dice& dice, const Joint& joint, bool on_child) {
  std::array<double, 3> axis{};
  switch (dice.below(3)) {
    case 0: {
      const auto R = model::rotation_matrix(joint.placement);
      for (std::size_t i = 0; i < 3; ++i) axis[i] = on_child ? (i == 2 ? 1.0 : 0.0) : model::evaluate(R[i][2]);
      break;
    }
    case 1:
      axis[static_cast<std::size_t>(dice.below(3))] = dice.sign();
      break;
    default:
      for (double& x : axis) x = dice.between(-0.5, 0.5);
  }
  for (double& x : axis) x += crumb(dice);
  return axis;
}

}  // namespace

KinematicTree with_ill_rotors(KinematicTree robot, std::uint64_t seed) {
  Dice dice(seed + 0x51afd7ed558ccd4b);
  for (Joint& joint : robot.joints) {
    if (!dice.chance(0.7)) continue;
    int carrier = dice.chance(0.6) ? joint.parent : dice.below(static_cast<int>(robot.links.size()));
    const model::Link& link = robot.links[static_cast<std::size_t>(carrier)];
    if (!link.inertia) carrier = joint.child;
    // A fraction of the carrier's inertia, because the carrier's inertia includes the spin inertia.
    const Inertia& body = *robot.links[static_cast<std::size_t>(carrier)].inertia;
    const double spin = 1e-3 * model::evaluate(body.ixx);
    model::Rotor& rotor = joint.drive.rotor.emplace();
    rotor.inertia = Quantity(spin);
    rotor.ratio = Quantity(dice.sign() * dice.between(1, 100));
    rotor.carrier = carrier;
    const std::array<double, 3> axis = noisy_axis(dice, joint, carrier == joint.child);
    rotor.axis = {Quantity(axis[0]), Quantity(axis[1]), Quantity(axis[2])};
  }
  return robot;
}

KinematicTree ill_robot(std::uint64_t seed) {
  Dice dice(seed * 0x9e3779b97f4a7c15ULL + 1);
  KinematicTree robot;
  robot.name = "ill_" + std::to_string(seed);
  Dice screws(seed + 0x2545f4914f6cdd1d);
  robot.floating_base = dice.chance(0.5);
  // Sizes and masses span this many decades on either side of metres and kilogrammes.
  const int decades = dice.chance(0.7) ? 0 : 1 + dice.below(6);
  const auto scale = [&] { return power_of_ten(dice.below(2 * decades + 1) - decades); };
  const double revolute = dice.chance(0.5) ? 1.0 : dice.unit();
  const int joints = 1 + dice.below(dice.chance(0.5) ? 4 : 12);
  const double chain = dice.between(0.5, 1.0);

  robot.links.push_back({"base", {}, -1, {}, {}});
  if (robot.floating_base) robot.links[0].inertia = body(dice, dice.between(1, 10), 1.0);
  for (int k = 0; k < joints; ++k) {
    const std::string number = std::to_string(k + 1);
    const double mass = dice.between(0.5, 5) * scale();
    robot.links.push_back({"link" + number, body(dice, mass, scale()), k, {}, {}});
    Joint joint;
    joint.name = "j" + number;
    joint.type = dice.chance(revolute) ? JointType::revolute : JointType::prismatic;
    joint.placement = placement(dice, scale());
    if (screws.chance(0.1)) {
      joint.type = JointType::helical;
      joint.pitch = model::Quantity(screws.sign() * power_of_ten(-screws.below(5)));
    }
    joint.parent = dice.chance(chain) ? k : dice.below(k + 1);
    joint.child = k + 1;
    robot.links[static_cast<std::size_t>(joint.parent)].child_joints.push_back(k);
    robot.joints.push_back(std::move(joint));
  }
  return robot;
}

}  // namespace robcogen::numeric
