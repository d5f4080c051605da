// Targets most of which no branch reaches: none is said to exist that misses its target, and all numbers are finite.
// The environment variable ROBCOGEN_TEST_TARGETS sets their number.
#include <gtest/gtest.h>
#include <offset_wrist/offset_wrist.h>
#include <puma560/puma560.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "robcogen/inverse_kinematics.h"

namespace robcogen::test::out_of_reach_test {
namespace {

struct Puma {
  static constexpr double kReach = 0.9;  // m
  static constexpr bool kReachesSome = true;
  using Joints = puma560::JointState;
  static constexpr auto kChain = puma560::inverse_kinematics::fr_base_X_fr_ee_joints;
  static constexpr auto kTypes = puma560::kJointTypes;
  static auto pose(const Joints& q) { return puma560::transforms::homogeneous::fr_base_X_fr_ee(q); }
  static auto branches(const Eigen::Matrix4d& X, const Joints& reference) {
    return puma560::inverse_kinematics::fr_base_X_fr_ee(X, reference);
  }
};

// Its first joint is given, at random: it reaches nothing.
struct OffsetWrist {
  static constexpr double kReach = 0.9;
  static constexpr bool kReachesSome = false;
  using Joints = offset_wrist::JointState;
  static constexpr auto kChain = offset_wrist::inverse_kinematics::fr_base_X_fr_tool_joints;
  static constexpr auto kTypes = offset_wrist::kJointTypes;
  static auto pose(const Joints& q) { return offset_wrist::transforms::homogeneous::fr_base_X_fr_tool(q); }
  static auto branches(const Eigen::Matrix4d& X, const Joints& reference) {
    return offset_wrist::inverse_kinematics::fr_base_X_fr_tool(X, reference);
  }
};

// Poses of the arm that are moved: anywhere, by up to the reach, from a singular position by 1e-14 m to 1 m, and far.
template <class Arm>
class Targets {
 public:
  Eigen::Matrix4d next() {
    typename Arm::Joints q = joints();
    const int kind = count_++ % 4;
    if (kind == 2)
      for (double& position : q)
        if (engine_() % 2 == 0) position = (static_cast<int>(engine_() % 5) - 2) * kQuarter;
    Eigen::Matrix4d X = Arm::pose(q);
    auto position = X.topRightCorner<3, 1>();
    const Eigen::Vector3d d = direction();
    if (kind == 0) position = 2 * Arm::kReach * uniform(0, 1) * d;
    if (kind == 1) position += Arm::kReach * uniform(0, 1) * d;
    if (kind == 2) position += std::pow(10.0, -static_cast<double>(engine_() % 15)) * d;
    if (kind == 3) position = Arm::kReach * std::pow(10.0, static_cast<double>(engine_() % 5)) * d;
    return X;
  }
  typename Arm::Joints joints() {
    typename Arm::Joints q;
    for (double& position : q) position = uniform(-2 * kQuarter, 2 * kQuarter);
    return q;
  }

 private:
  static constexpr double kQuarter = 1.57079632679489661923;
  std::mt19937_64 engine_{51};
  int count_ = 0;

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Eigen::Vector3d direction() {
    Eigen::Vector3d d;
    do {
      for (double& x : d) x = uniform(-1, 1);
    } while (d.squaredNorm() > 1 || d.squaredNorm() < 1e-4);
    return d.normalized();
  }
};

template <class>
class OutOfReach : public testing::Test {};
using Arms = testing::Types<Puma, OffsetWrist>;
TYPED_TEST_SUITE(OutOfReach, Arms);

TYPED_TEST(OutOfReach, NoBranchIsSaidToExistThatMisses) {
  constexpr double kExists = 1e-9, kRounding = 1e-12;
  const char* const number = std::getenv("ROBCOGEN_TEST_TARGETS");
  const int count = number ? std::atoi(number) : 20000;
  Targets<TypeParam> targets;
  int missed = 0, reached = 0;
  for (int i = 0; i < count; ++i) {
    const Eigen::Matrix4d X = targets.next();
    const typename TypeParam::Joints reference = targets.joints();
    const auto branches = TypeParam::branches(X, reference);
    const double size = std::max(1.0, X.cwiseAbs().maxCoeff());
    for (int branch = 0; branch < branches.misfit.size(); ++branch) {
      const double misfit = branches.misfit[branch];
      ASSERT_TRUE(std::isfinite(misfit) && std::isfinite(branches.determinant[branch]));
      const auto q = branch_positions(branches, TypeParam::kChain, TypeParam::kTypes, branch, reference);
      ASSERT_TRUE(q.allFinite());
      const double error = (TypeParam::pose(q) - X).cwiseAbs().maxCoeff();
      ASSERT_LE(error, misfit + kRounding * size);
      ++(misfit < kExists ? reached : missed);
      if (misfit < kExists) {
        ASSERT_LE(error, kExists);
      }
    }
  }
  EXPECT_GT(missed, count / 2);
  EXPECT_EQ(reached > 0, TypeParam::kReachesSome);
}

}  // namespace
}  // namespace robcogen::test::out_of_reach_test
