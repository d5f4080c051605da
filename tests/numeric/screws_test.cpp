// Helical joints: without a pitch they are revolute; with one they are a rotation to which a translation is coupled.
#include <gtest/gtest.h>

#include "interpreted_robot.h"
#include "random_drives.h"
#include "random_robot.h"

namespace robcogen::numeric::screws_test {
namespace {

using model::JointType;
using model::KinematicTree;
using model::Quantity;
using reference::Vector;

constexpr double kSame = 1e-10;  // relative to the largest element; sums are rounded in another order

double relative(const reference::Matrix<double>& found, const reference::Matrix<double>& wanted) {
  return reference::largest(found - wanted) / (1 + reference::largest(wanted));
}

KinematicTree robot_with(std::uint64_t seed, const std::function<void(model::Joint&, double pitch)>& change) {
  RobotOptions options;
  options.max_joints = 12;
  KinematicTree robot = with_random_drives(random_robot(seed, options), seed);
  for (std::size_t j = seed % 2; j < robot.joints.size(); j += 2)
    change(robot.joints[j], 0.1 + 0.05 * static_cast<double>(j));
  return robot;
}

void make_screw(model::Joint& joint, double pitch) {
  joint.type = JointType::helical;
  joint.pitch = Quantity(pitch);
}

// Compares the dynamics of both robots in one random state.
void expect_same(const KinematicTree& a, const KinematicTree& b, std::uint64_t seed) {
  const InterpretedRobot first(a, {}), second(b, {}, {});
  std::mt19937_64 engine(seed);
  const reference::Motion<double> m = reference::random_sample(engine, first.tables()).motion;
  SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + describe(a));
  EXPECT_LT(
      relative(first.inverse_dynamics_fully_actuated(m, {}), second.inverse_dynamics_fully_actuated(m, {})), kSame);
  EXPECT_LT(relative(first.bias_forces(m, {}), second.bias_forces(m, {})), kSame);
  EXPECT_LT(relative(first.joint_space_inertia(m.q), second.joint_space_inertia(m.q)), kSame);
  EXPECT_LT(relative(first.coriolis_matrix(m), second.coriolis_matrix(m)), kSame);
  EXPECT_NEAR(first.kinetic_energy(m), second.kinetic_energy(m), kSame * (1 + second.kinetic_energy(m)));
}

TEST(Screws, WithoutPitchAreRevolute) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const KinematicTree screws = robot_with(seed, [](model::Joint& joint, double) { make_screw(joint, 0.0); });
    const KinematicTree hinges = robot_with(seed, [](model::Joint& joint, double) {
      joint.type = JointType::revolute;
      joint.pitch = Quantity();
    });
    expect_same(screws, hinges, seed);
  }
}

// The effect of the pitch is linear, however small it is.
TEST(Screws, ApproachHingesAsThePitchVanishes) {
  const auto energy = [](double pitch) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const InterpretedRobot robot(robot_with(seed, [&](model::Joint& j, double) { make_screw(j, pitch); }), {}, {});
      std::mt19937_64 engine(seed);
      sum += robot.kinetic_energy(reference::random_sample(engine, robot.tables()).motion);
    }
    return sum;
  };
  const double hinge = energy(0.0), slope = (energy(1e-4) - energy(-1e-4)) / 2e-4;
  EXPECT_GT(std::abs(slope), 1e-3);
  EXPECT_NEAR(energy(1e-7), hinge + 1e-7 * slope, 1e-9);
  EXPECT_NEAR(energy(1e-12), hinge, 1e-9);
}

// Adds a prismatic joint with a massless link in front of each screw, which becomes a revolute joint.
KinematicTree with_slides(const KinematicTree& screws) {
  KinematicTree robot = screws;
  const auto count = static_cast<int>(robot.joints.size());
  for (int j = 0; j < count; ++j) {
    const auto here = static_cast<std::size_t>(j);
    if (robot.joints[here].type != JointType::helical) continue;
    model::Joint slide = robot.joints[here];
    const auto link = static_cast<int>(robot.links.size()), added = static_cast<int>(robot.joints.size());
    slide.name += "_slide";
    slide.type = JointType::prismatic;
    slide.drive = {};
    slide.child = link;
    robot.links.push_back({slide.name + "_link", {}, added, {j}, {}});
    for (int& child : robot.links[static_cast<std::size_t>(slide.parent)].child_joints)
      if (child == j) child = added;
    robot.couplings.push_back({added, {{j, slide.pitch}}, {}});
    slide.pitch = Quantity();
    robot.joints.push_back(slide);
    model::Joint& hinge = robot.joints[here];
    if (hinge.drive.rotor && !hinge.drive.rotor->axis) hinge.drive.rotor->axis = rotor_axis(hinge);
    hinge.type = JointType::revolute;
    hinge.pitch = Quantity();
    hinge.parent = link;
    hinge.placement = {};
  }
  return robot;
}

TEST(Screws, AreSlidesThatFollowHinges) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const KinematicTree screws = robot_with(seed, make_screw);
    expect_same(screws, with_slides(screws), seed);
  }
}

}  // namespace
}  // namespace robcogen::numeric::screws_test
