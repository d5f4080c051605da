// The kinematics plugin for MoveIt.
#include <urdf_parser/urdf_parser.h>
#include <moveit/kinematics_base/kinematics_base.hpp>

#include <Eigen/Geometry>

#include "../real_time/allocation_hook.h"
#include "plugins.h"

namespace robcogen::test::moveit_test {
namespace {

using Error = moveit_msgs::msg::MoveItErrorCodes;
using kinematics::KinematicsBase;
using moveit::core::RobotModel;
using Pose = geometry_msgs::msg::Pose;
using Vector = std::vector<double>;

RobotModel model(const std::string& text = description()) {
  RobotModel result;
  result.urdf = urdf::parseURDF(text);
  std::vector<std::string> joints;
  for (int j = 0; j < 6; ++j) {
    joints.push_back("joint_" + std::to_string(j + 1));
    const auto& limits = arm::kJointLimits[static_cast<std::size_t>(j)];
    result.bounds[joints.back()] = {limits.lower, limits.upper, true};
  }
  result.groups.emplace("arm", moveit::core::JointModelGroup(joints));
  return result;
}

std::unique_ptr<KinematicsBase> initialized(
    const RobotModel& robot = model(),
    const std::string& base = "base_link",
    const std::string& tip = "tool0") {
  auto plugin = load<KinematicsBase>(MOVEIT);
  EXPECT_TRUE(plugin->initialize(nullptr, robot, "arm", base, {tip}, 0.1)) << last_message();
  return plugin;
}

std::string refused(
    const RobotModel& robot,
    const std::string& group,
    const std::string& base,
    const std::vector<std::string>& tips) {
  const auto plugin = load<KinematicsBase>(MOVEIT);
  EXPECT_FALSE(plugin->initialize(nullptr, robot, group, base, tips, 0.1));
  return last_message().substr(std::string("robcogen.six_axis: ").size());
}

Vector vector(const arm::JointState& q) {
  return Vector(q.data(), q.data() + 6);
}

Pose pose_of(const KinematicsBase& plugin, const Vector& q) {
  std::vector<Pose> poses;
  EXPECT_TRUE(plugin.getPositionFK(plugin.getTipFrames(), q, poses));
  return poses.at(0);
}

double distance(const Pose& a, const Pose& b) {
  const Eigen::Vector3d d(a.position.x - b.position.x, a.position.y - b.position.y, a.position.z - b.position.z);
  const Eigen::Quaterniond p(a.orientation.w, a.orientation.x, a.orientation.y, a.orientation.z);
  const Eigen::Quaterniond q(b.orientation.w, b.orientation.x, b.orientation.y, b.orientation.z);
  return std::max(d.norm(), p.angularDistance(q));
}

double distance(const Vector& a, const Vector& b) {
  double most = 0;
  for (std::size_t j = 0; j < a.size(); ++j) most = std::max(most, std::abs(a[j] - b[j]));
  return most;
}

TEST(MoveIt, SolutionsReachThePose) {
  const auto plugin = initialized();
  EXPECT_EQ(plugin->getJointNames(), model().groups.at("arm").getVariableNames());
  EXPECT_EQ(plugin->getLinkNames(), std::vector<std::string>{"tool0"});
  for (int i = 0; i < 200; ++i) {
    const Vector q = vector(some_positions(i)), seed = vector(some_positions(i + 300));
    const Pose pose = pose_of(*plugin, q);
    Vector solution;
    Error error;
    ASSERT_TRUE(plugin->getPositionIK(pose, q, solution, error));
    EXPECT_EQ(error.val, Error::SUCCESS);
    EXPECT_LT(distance(solution, q), 1e-6) << "the nearest is the seed itself";
    ASSERT_TRUE(plugin->searchPositionIK(pose, seed, 1, solution, error));
    EXPECT_LT(distance(pose_of(*plugin, solution), pose), 1e-9);
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_GE(solution[j], arm::kJointLimits[j].lower - 1e-9);
      EXPECT_LE(solution[j], arm::kJointLimits[j].upper + 1e-9);
    }
  }
}

TEST(MoveIt, AllSolutions) {
  const auto plugin = initialized();
  const Vector q = vector(some_positions(2));
  const Pose pose = pose_of(*plugin, q);
  std::vector<Vector> solutions;
  kinematics::KinematicsResult result;
  ASSERT_TRUE(plugin->getPositionIK(std::vector<Pose>{pose}, q, solutions, result, {}));
  EXPECT_EQ(result.kinematic_error, kinematics::KinematicErrors::OK);
  EXPECT_GE(solutions.size(), 2U);
  EXPECT_LT(distance(solutions.front(), q), 1e-6);
  for (const Vector& solution : solutions) EXPECT_LT(distance(pose_of(*plugin, solution), pose), 1e-9);
  for (std::size_t k = 1; k < solutions.size(); ++k) EXPECT_GT(distance(solutions[k], solutions[k - 1]), 1e-3);

  EXPECT_FALSE(plugin->getPositionIK(std::vector<Pose>{pose, pose}, q, solutions, result, {}));
  EXPECT_EQ(result.kinematic_error, kinematics::KinematicErrors::MULTIPLE_TIPS_NOT_SUPPORTED);
  EXPECT_FALSE(plugin->getPositionIK(std::vector<Pose>{}, q, solutions, result, {}));
  EXPECT_EQ(result.kinematic_error, kinematics::KinematicErrors::EMPTY_TIP_POSES);
  kinematics::KinematicsQueryOptions options;
  options.discretization_method = kinematics::DiscretizationMethods::ALL_DISCRETIZED;
  EXPECT_FALSE(plugin->getPositionIK(std::vector<Pose>{pose}, q, solutions, result, options));
  EXPECT_EQ(result.kinematic_error, kinematics::KinematicErrors::UNSUPORTED_DISCRETIZATION_REQUESTED);
}

TEST(MoveIt, CallbacksChooseAmongSolutions) {
  const auto plugin = initialized();
  const Vector q = vector(some_positions(2));
  const Pose pose = pose_of(*plugin, q);
  Vector solution;
  Error error;
  int calls = 0;
  const auto second = [&](const Pose&, const Vector&, Error& answer) {
    answer.val = ++calls == 2 ? Error::SUCCESS : Error::NO_IK_SOLUTION;
  };
  ASSERT_TRUE(plugin->searchPositionIK(pose, q, 1, solution, second, error));
  EXPECT_EQ(calls, 2);
  EXPECT_GT(distance(solution, q), 1e-3);
  EXPECT_LT(distance(pose_of(*plugin, solution), pose), 1e-9);
  const auto never = [](const Pose&, const Vector&, Error& answer) { answer.val = Error::NO_IK_SOLUTION; };
  EXPECT_FALSE(plugin->searchPositionIK(pose, q, 1, solution, never, error));
  EXPECT_EQ(error.val, Error::NO_IK_SOLUTION);
}

TEST(MoveIt, KeepsToLimits) {
  const Vector q = vector(some_positions(4));
  RobotModel narrow = model();
  const Pose pose = pose_of(*initialized(), q);
  // Consistency: near the seed, within which only the position itself is.
  Vector near = q, solution;
  for (double& position : near) position += 0.02;
  Error error;
  const auto plugin = initialized();
  ASSERT_TRUE(plugin->searchPositionIK(pose, near, 1, Vector(6, 0.05), solution, error));
  EXPECT_LT(distance(solution, q), 1e-6);
  EXPECT_FALSE(plugin->searchPositionIK(pose, near, 1, Vector(6, 0.01), solution, error));
  EXPECT_EQ(error.val, Error::NO_IK_SOLUTION);
  // Limits of the robot model, which may be narrower than those of the library.
  narrow.bounds["joint_2"] = {q[1] + 0.01, q[1] + 0.02, true};
  EXPECT_FALSE(initialized(narrow)->getPositionIK(pose, q, solution, error));
}

TEST(MoveIt, OtherLinksFixedToTheFrames) {
  // wrist_3 carries tool0, and base_link is the frame fr_base.
  const auto plugin = initialized(model(), "base_link", "wrist_3");
  const Vector q = vector(some_positions(5));
  Vector solution;
  Error error;
  const Pose pose = pose_of(*plugin, q);
  ASSERT_TRUE(plugin->getPositionIK(pose, q, solution, error));
  EXPECT_LT(distance(solution, q), 1e-6);
}

TEST(MoveIt, OutOfReach) {
  const auto plugin = initialized();
  const Vector q = vector(some_positions(1));
  Pose pose = pose_of(*plugin, q);
  pose.position.x += 3;
  Vector solution;
  Error error;
  EXPECT_FALSE(plugin->getPositionIK(pose, q, solution, error));
  EXPECT_EQ(error.val, Error::NO_IK_SOLUTION);
  kinematics::KinematicsQueryOptions options;
  options.return_approximate_solution = true;
  if (plugin->getPositionIK(pose, q, solution, error, options)) {
    Pose there = pose_of(*plugin, solution);
    EXPECT_GT(there.position.x, 0.3) << "towards the target";
  }
}

TEST(MoveIt, RefusesWrongArguments) {
  const auto plugin = load<KinematicsBase>(MOVEIT);
  Vector solution;
  Error error;
  std::vector<Pose> poses;
  EXPECT_FALSE(plugin->getPositionIK(Pose(), Vector(6), solution, error));
  EXPECT_EQ(last_message(), "robcogen.six_axis: the solver is not initialised");
  EXPECT_FALSE(plugin->getPositionFK({"tool0"}, Vector(6), poses));
  ASSERT_TRUE(plugin->initialize(nullptr, model(), "arm", "base_link", {"tool0"}, 0.1));
  EXPECT_FALSE(plugin->getPositionIK(Pose(), Vector(5), solution, error));
  EXPECT_EQ(last_message(), "robcogen.six_axis: ik_seed_state has 5 elements instead of 6");
  EXPECT_EQ(error.val, Error::NO_IK_SOLUTION);
  EXPECT_FALSE(plugin->searchPositionIK(Pose(), Vector(6), 1, Vector(7), solution, error));
  EXPECT_EQ(last_message(), "robcogen.six_axis: consistency_limits has 7 elements instead of 6");
  Pose none;
  none.orientation.w = 0;
  EXPECT_FALSE(plugin->getPositionIK(none, Vector(6), solution, error));
  EXPECT_FALSE(plugin->getPositionIK(Pose(), Vector(6, std::nan("")), solution, error));
  EXPECT_FALSE(plugin->getPositionFK({"hand"}, Vector(6), poses));
  EXPECT_FALSE(plugin->getPositionFK({"tool0"}, Vector(7), poses));
}

TEST(MoveIt, RefusesOtherGroups) {
  EXPECT_EQ(
      refused(model(), "arm", "base_link", {"tool0", "forearm"}), "group 'arm' has 2 tips; this solver is for one");
  EXPECT_EQ(refused(model(), "hand", "base_link", {"tool0"}), "group 'hand': the robot model has no such group");
  EXPECT_EQ(
      refused(model(), "arm", "base_link", {"forearm"}),
      "group 'arm': the library has no inverse kinematics from 'base_link' to 'forearm'; it has base_link:tool0 "
      "(INVERSE_KINEMATICS of robcogen_add_robot)");
  EXPECT_TRUE(
      refused(model(), "arm", "base_link", {"hand"}).starts_with("group 'arm': robot 'six_axis' has no link 'hand'"));
  RobotModel fewer = model();
  fewer.groups.at("arm") = moveit::core::JointModelGroup({"joint_1", "joint_2"});
  EXPECT_EQ(
      refused(fewer, "arm", "base_link", {"tool0"}), "group 'arm': it does not have joint 'joint_3' of the chain");
  EXPECT_TRUE(refused(model(description_with("0.45 0 0", "0.46 0 0")), "arm", "base_link", {"tool0"})
                  .starts_with("the robot description is not that of the generated robot 'six_axis'"));
}

TEST(MoveIt, AllocatesNothing) {
  const auto plugin = initialized();
  const Vector q = vector(some_positions(3)), seed = vector(some_positions(30)), consistency(6, 10.0);
  const Pose pose = pose_of(*plugin, q);
  Vector solution(6);
  Error error;
  bool is_good = true;
  {
    const NoAllocation none("the plugin for MoveIt");
    is_good = plugin->getPositionIK(pose, seed, solution, error) &&
              plugin->searchPositionIK(pose, seed, 1.0, consistency, solution, error);
  }
  EXPECT_TRUE(is_good);
}

}  // namespace
}  // namespace robcogen::test::moveit_test
