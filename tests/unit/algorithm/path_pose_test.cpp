// The frame that a path has reached, compared with Eigen's products of poses.
#include "algorithm/kinematics/path_pose.h"

#include "bodies.h"

namespace robcogen::algorithm::path_pose_test {
namespace {

using test::kTolerance;
using test::Numbers;
using test::RandomPose;

constexpr double kProducts = 20 * kTolerance;  // of up to four poses

// A walk over a few poses, and the pose to which it leads.
class Walks : public testing::TestWithParam<int> {
 protected:
  Numbers n{static_cast<unsigned>(GetParam())};
  std::vector<RandomPose> poses;
  Eigen::Isometry3d end = Eigen::Isometry3d::Identity();

  void SetUp() override {
    for (int k = 1 + n.pick(4); k > 0; --k) {
      poses.emplace_back(n);
      end = end * poses.back().transform;
    }
  }
  PathPose walk(int moment_from = PathPose::kNoSegment) {
    PathPose here = start(n.graph, moment_from);
    for (const RandomPose& each : poses) advance(here, each.pose);
    return here;
  }
};

TEST_P(Walks, EndWhereThePosesLead) {
  const PathPose here = walk();
  EXPECT_TRUE(n.value(here.rotation).isApprox(end.linear(), kProducts));
  EXPECT_TRUE(n.value(here.position).isApprox(end.translation(), kProducts));
}

// Wherever the moment begins, its final value is [p]x R.
TEST_P(Walks, CarryTheMoment) {
  const Eigen::Matrix3d expected = test::cross_matrix(end.translation()) * end.linear();
  for (int from = 0; from < static_cast<int>(poses.size()); ++from)
    EXPECT_TRUE(n.value(walk(from).moment).isApprox(expected, kProducts)) << from;
}

// The rotation's factors are kept: before.front() * planes[0] * planes[1] …
TEST_P(Walks, RememberHowTheRotationCameAbout) {
  const PathPose here = walk();
  ASSERT_EQ(here.before.size(), here.planes.size());
  Eigen::Matrix3d product = here.before.empty() ? n.value(here.rotation) : n.value(here.before.front());
  for (std::size_t k = 0; k < here.planes.size(); ++k) {
    EXPECT_TRUE(n.value(here.before[k]).isApprox(product, kProducts)) << k;
    product = product * test::turn(here.planes[k].axis, n.value(here.planes[k].angle));
    if (k == 0) continue;
    EXPECT_NE(here.planes[k].axis, here.planes[k - 1].axis);
  }
  EXPECT_TRUE(product.isApprox(end.linear(), kProducts));
}

INSTANTIATE_TEST_SUITE_P(, Walks, testing::Range(0, 40));

Pose turned(int axis, const Expression& angle) {
  Pose pose;
  pose.rotation.planes = {{axis, cos(angle), sin(angle), angle}};
  return pose;
}

TEST(PathPose, ATurnThereAndBackCostsNothing) {
  Numbers n;
  const Expression angle = n.expression(0.7), other = n.expression(-0.4);
  PathPose here = start(n.graph);
  advance(here, turned(0, other));
  const Matrix3 before = here.rotation;
  advance(here, turned(2, angle));
  advance(here, turned(2, -angle));
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_TRUE(here.rotation[k][c] == before[k][c]) << k << c;
}

// The matrix of three Euler angles takes at most 12 products, for any sequence of axes.
TEST(PathPose, EulerAnglesCostTwelveProducts) {
  for (int first = 0; first < 3; ++first)
    for (int second = 0; second < 3; ++second)
      for (int third = 0; third < 3; ++third) {
        if (first == second || second == third) continue;
        Numbers n;
        PathPose here = start(n.graph);
        Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();
        for (const auto& [axis, angle] : {std::pair(first, 0.3), std::pair(second, -1.1), std::pair(third, 0.8)}) {
          advance(here, turned(axis, n.expression(angle)));
          expected = expected * test::turn(axis, angle);
        }
        const symbolic::Cost c = n.count(test::flat(here.rotation));
        EXPECT_LE(c.mul, 12) << first << second << third;
        EXPECT_EQ(c.sincos, 3);
        EXPECT_TRUE(n.value(here.rotation).isApprox(expected, kTolerance)) << first << second << third;
      }
}

TEST(PathPose, MotionsChangeAxes) {
  Numbers n;
  const Matrix3 m = n.matrix();
  const Motion motion{n.vector(), n.vector()};
  EXPECT_EQ(n.value(column(m, 1)), n.value(m).col(1));
  for (const bool negated : {false, true}) {
    const double sign = negated ? -1 : 1;
    const Motion there = in_axes(m, motion, negated);
    EXPECT_TRUE(n.value(there.angular).isApprox(sign * n.value(m) * n.value(motion.angular), kTolerance));
    EXPECT_TRUE(n.value(there.linear).isApprox(sign * n.value(m) * n.value(motion.linear), kTolerance));
  }
}

// A program with `count` products.
symbolic::Program products(int count) {
  Numbers n;
  Expression value = n.expression(1);
  for (int k = 0; k < count; ++k) value = value * n.expression(2);
  return test::program(n.graph, n.inputs.size(), {value});
}

TEST(CheapestTransform, IsTheCheapestOfTheForms) {
  for (const int best : {0, 3, PathPose::kNoSegment}) {
    std::vector<int> tried;
    const auto make = [&](int moment_from) {
      tried.push_back(moment_from);
      return products(moment_from == best ? 2 : 5);
    };
    EXPECT_EQ(symbolic::cost(cheapest_transform(TransformForm::spatial_motion, 3, make)).mul, 2) << best;
    EXPECT_EQ(tried.size(), 3U);
    tried.clear();
    cheapest_transform(TransformForm::homogeneous, 3, make);
    EXPECT_EQ(tried, std::vector<int>{PathPose::kNoSegment});
  }
}

}  // namespace
}  // namespace robcogen::algorithm::path_pose_test
