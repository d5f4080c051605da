// The search over branches and redundancy, with solvers written by hand: an arm of two joints about one axis, whose sum
// turns the hand.
#include <gtest/gtest.h>

#include "robcogen/ros/inverse_kinematics.h"

namespace robcogen::test::search_test {
namespace {

using ros::Outcome;
using ros::Task;
using Joints = Eigen::Vector2d;
using Request = ros::Request<Joints, 2>;

constexpr std::array kTypes = {JointType::revolute, JointType::revolute};

// One solution, joint 1, and another one that does not exist.
struct Branches {
  Eigen::Matrix<double, 1, 2> sin_q, cos_q;
  Eigen::Vector2d misfit;
};
Branches branches_at(double angle) {
  return {{std::sin(angle), 0}, {std::cos(angle), 1}, {0, 0.5}};
}

// With joint 0 given.
struct Given {
  static constexpr auto kTask = Task::pose;
  static constexpr std::array kJoints = {1};
  static Branches branches(const Eigen::Matrix4d& X, const Joints& reference) {
    return branches_at(std::atan2(X(1, 0), X(0, 0)) - reference[0]);
  }
};

// With a swivel angle, which here shifts joint 1.
struct Swivel {
  static constexpr auto kTask = Task::swivel;
  static constexpr std::array kJoints = {1};
  static Branches branches(const Eigen::Matrix4d&, const Eigen::Matrix<double, 1, 1>& swivel, const Joints&) {
    return branches_at(swivel[0]);
  }
  static Eigen::Matrix<double, 1, 1> redundancy(const Joints& q) { return Eigen::Matrix<double, 1, 1>(q[1]); }
};

Request request(double angle, Joints seed) {
  Request result;
  result.X = Eigen::Isometry3d(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
  result.seed = seed;
  result.step = 0.25;
  return result;
}

std::vector<Joints> all(const Request& r) {
  std::vector<Joints> found;
  EXPECT_EQ(
      ros::search<Given>(
          kTypes, r,
          [&](const Joints& q) {
            found.push_back(q);
            return false;
          },
          [] { return false; }),
      Outcome::none);
  return found;
}

TEST(Search, StepsAwayFromTheSeed) {
  Request r = request(1, {0.5, 0});
  r.given = 0;
  r.limits[0].lower = -0.1;
  r.limits[0].upper = 1;
  const std::vector<Joints> found = all(r);
  std::vector<double> given;
  for (const Joints& q : found) {
    given.push_back(q[0]);
    EXPECT_NEAR(q.sum(), 1, 1e-12);
  }
  EXPECT_EQ(given, (std::vector<double>{0.5, 0.75, 0.25, 1, 0}));
  r.keeps_given = true;
  EXPECT_EQ(all(r).size(), 1U);
  r.seed[0] = 1.5;  // beyond the limit
  EXPECT_EQ(all(r).size(), 0U);
  r.keeps_given = false;
  EXPECT_EQ(all(r).size(), 5U);
}

TEST(Search, WithoutLimitsTriesATurn) {
  Request r = request(1, {0.5, 0});
  r.given = 0;
  EXPECT_EQ(all(r).size(), 25U);  // 12 steps of 0.25 rad either way
}

TEST(Search, AnotherPositionIsWithinLimits) {
  // With the given joint where it is, joint 1 would be beyond its limit.
  Request r = request(1, {0.0, 0.4});
  r.given = 0;
  r.limits[1].lower = -1;
  r.limits[1].upper = 0.5;
  Joints found;
  const auto take = [&](const Joints& q) {
    found = q;
    return true;
  };
  EXPECT_EQ(ros::search<Given>(kTypes, r, take, [] { return false; }), Outcome::found);
  EXPECT_LT((found - Joints(0.5, 0.5)).norm(), 1e-12);
  int steps = 0;
  EXPECT_EQ(ros::search<Given>(kTypes, r, take, [&] { return ++steps == 2; }), Outcome::stopped);
}

TEST(Search, Swivel) {
  Request r = request(0, {0.0, 0.3});
  r.limits[1].lower = 0.5;
  r.limits[1].upper = 0.7;
  Joints found;
  const auto take = [&](const Joints& q) {
    found = q;
    return true;
  };
  EXPECT_EQ(ros::search<Swivel>(kTypes, r, take, [] { return false; }), Outcome::found);
  EXPECT_NEAR(found[1], 0.55, 1e-12);
}

TEST(Search, LeastMisfitIfAsked) {
  struct Nowhere : Given {
    static Branches branches(const Eigen::Matrix4d&, const Joints&) { return {{0, 1}, {1, 0}, {0.5, 0.2}}; }
  };
  Request r = request(0, {0, 0});
  Joints found = Joints::Constant(7);
  const auto take = [&](const Joints& q) {
    found = q;
    return true;
  };
  EXPECT_EQ(ros::search<Nowhere>(kTypes, r, take, [] { return false; }), Outcome::none);
  r.approximate = true;
  EXPECT_EQ(ros::search<Nowhere>(kTypes, r, take, [] { return false; }), Outcome::found);
  EXPECT_NEAR(found[1], 1.5707963267948966, 1e-12);
}

}  // namespace
}  // namespace robcogen::test::search_test
