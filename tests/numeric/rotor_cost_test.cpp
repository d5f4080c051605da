// The cost of drives in inverse dynamics.
#include <gtest/gtest.h>

#include <cmath>

#include "algorithm/catalogue/catalogue.h"
#include "dice.h"
#include "pass/passes.h"
#include "random_robot.h"
#include "support/index.h"
#include "symbolic/cost.h"

namespace robcogen::numeric::rotor_cost_test {
namespace {

using model::KinematicTree;
using model::Quantity;

// Chains in which every link has all ten inertial parameters.
KinematicTree chain(std::uint64_t seed, int joints = 4) {
  RobotOptions options;
  options.min_joints = options.max_joints = joints;
  options.shape = Shape::chain;
  options.odd_documents = options.screws = false;
  KinematicTree robot = random_robot(seed, options);
  Dice dice(seed);
  for (model::Joint& joint : robot.joints) {
    joint.type = model::JointType::revolute;
    for (Quantity& angle : joint.placement.rotation) angle = Quantity(dice.between(0.3, 1.2));
    for (Quantity& offset : joint.placement.translation) offset = Quantity(dice.between(0.1, 0.4));
  }
  for (model::Link& link : robot.links) {
    model::Inertia& body = link.inertia.emplace();
    body.mass = Quantity(dice.between(1, 3));
    for (Quantity& c : body.com) c = Quantity(dice.between(0.02, 0.2));
    for (Quantity* moment : {&body.ixx, &body.iyy, &body.izz}) *moment = Quantity(dice.between(0.4, 0.6));
    for (Quantity* product : {&body.ixy, &body.ixz, &body.iyz}) *product = Quantity(dice.between(0.01, 0.04));
  }
  return robot;
}

// Multiplications, additions and divisions of inverse dynamics with all accelerations given, in the model's link
// frames.
int operations(const KinematicTree& robot) {
  const std::string name = robot.floating_base ? "inverse_dynamics_fully_actuated" : "inverse_dynamics";
  for (symbolic::Function& f : algorithm::functions(robot, {}, "inverse_dynamics")) {
    if (f.name != name) continue;
    const symbolic::Cost n = symbolic::cost(pass::run(std::move(f.program), pass::names()));
    return n.mul + n.add + n.div;
  }
  throw std::logic_error("no inverse dynamics");
}

// Returns the last joint but one.
int joint_of(const KinematicTree& robot) {
  return robot.parent_joint_of(robot.topological().back());
}

using Axis = std::array<double, 3>;

KinematicTree geared(KinematicTree robot, int joint, int carrier, const std::optional<Axis>& axis) {
  model::Rotor& rotor = robot.joints[at(joint)].drive.rotor.emplace();
  rotor.inertia = Quantity(3e-4);
  rotor.ratio = Quantity(7.5);
  rotor.carrier = carrier;
  if (axis) rotor.axis = {Quantity((*axis)[0]), Quantity((*axis)[1]), Quantity((*axis)[2])};
  return robot;
}

// Returns the number of operations that a rotor on the last joint but one adds.
int cost(const KinematicTree& robot, const std::optional<Axis>& axis, int carrier) {
  return operations(geared(robot, joint_of(robot), carrier, axis)) - operations(robot);
}

Axis any_axis(Dice& dice) {
  return {dice.between(0.1, 1), dice.between(0.1, 1), dice.between(0.1, 1)};
}

constexpr int kRobots = 40;

TEST(DriveCosts, AnArmatureTakesAProductAndASum) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const KinematicTree robot = chain(seed);
    KinematicTree geared = robot;
    for (model::Joint& joint : geared.joints) joint.drive.armature = Quantity(0.02);
    EXPECT_LE(operations(geared) - operations(robot), 2 * robot.dof()) << seed;
  }
}

TEST(DriveCosts, ARotorAlongItsJointCostsAnArmature) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const KinematicTree robot = chain(seed);
    const model::Joint& joint = robot.joints[at(joint_of(robot))];
    EXPECT_LE(cost(robot, std::nullopt, joint.parent), 2) << seed;
    EXPECT_LE(cost(robot, std::nullopt, joint.child), 2) << seed;
  }
}

TEST(DriveCosts, ARotorAlongAnAxisOfItsCarrierTakesElevenOperations) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const KinematicTree robot = chain(seed);
    for (int carrier = 1; carrier < static_cast<int>(robot.links.size()); ++carrier)
      for (const Axis& axis : {Axis{1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0}})
        EXPECT_LE(cost(robot, axis, carrier), 11) << seed << " on link " << carrier;
  }
}

// Where the joint axis is fixed in the carrier, the inertias of the bodies include one component of the rotor's
// momentum.
TEST(DriveCosts, ARotorAboutAnyAxisTakesTwentyOperationsBesideItsJointAndTwentyEightElsewhere) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const KinematicTree robot = chain(seed);
    const model::Joint& joint = robot.joints[at(joint_of(robot))];
    Dice dice(seed);
    const Axis axis = any_axis(dice);
    for (int carrier = 1; carrier < static_cast<int>(robot.links.size()); ++carrier) {
      const bool is_beside = carrier == joint.parent || carrier == joint.child;
      EXPECT_LE(cost(robot, axis, carrier), is_beside ? 20 : 28) << seed << " on link " << carrier;
    }
  }
}

// Four rotors on an arm: three on the parents of their joints, one of which turns about a fixed axis, and one further
// down.
TEST(DriveCosts, RotorsAboutAnyAxesOnAnArmTakeNineteenOperationsEach) {
  constexpr int kJoints = 7;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    KinematicTree robot = chain(seed, kJoints);
    if (robot.floating_base) continue;
    const int without = operations(robot);
    const std::vector<int> joints = robot.topological();
    const auto link = [&](int place) { return robot.joints[at(joints[at(place)])].child; };
    Dice dice(seed);
    for (const auto& [joint, carrier] : {std::pair{1, 0}, {2, 1}, {4, 3}, {5, 2}})
      robot = geared(robot, joints[at(joint)], link(carrier), any_axis(dice));
    EXPECT_LE(operations(robot) - without, 4 * 19) << seed;
  }
}

// The joint axis is normal to that of its parent, as in legs and arms: the component along the joint axis is left out.
TEST(DriveCosts, ARotorAboutAnyAxisTakesTwentyOperationsWhereAxesAreNormal) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    KinematicTree robot = chain(seed);
    model::Joint& joint = robot.joints[at(joint_of(robot))];
    joint.placement.rotation = {Quantity(Number::pi_multiple(1, 2)), Quantity(), Quantity()};
    Dice dice(seed);
    const Axis axis = any_axis(dice);
    EXPECT_LE(cost(robot, axis, joint.parent), 20) << seed;
  }
}

}  // namespace
}  // namespace robcogen::numeric::rotor_cost_test
