// The effects of updates, and the sources of values.
#include <everywhere_fixed/everywhere_fixed.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <string>

#include "values.h"

namespace robcogen::test::update_test {
namespace {

using namespace everywhere_fixed;

const JointState kQ(0.3, -0.7, 0.2, 1.1), kQd(1.0, -0.4, 0.3, 2.0), kQdd(0.5, 1.5, -2.0, 0.7);

bool same(const Parameters<>& a, const Parameters<>& b) {
  return std::equal(a.data(), a.data() + Parameters<>::size(), b.data()) && a.array() == b.array();
}

// A user's own source of values.
class Scaled : public KinematicsParameters, public DynamicsParameters {
 public:
  explicit Scaled(const ParameterValues& values, double scale) : values_(values), scale_(scale) {}

  double get_camera_tilt() const noexcept override { return scale_ * values_.camera_tilt; }
  double get_camera_x() const noexcept override { return scale_ * values_.camera_x; }
  double get_fore() const noexcept override { return scale_ * values_.fore; }
  double get_lean() const noexcept override { return scale_ * values_.lean; }
  double get_offset() const noexcept override { return scale_ * values_.offset; }
  double get_twist() const noexcept override { return scale_ * values_.twist; }
  double get_upper() const noexcept override { return scale_ * values_.upper; }
  double get_arm_x() const noexcept override { return scale_ * values_.arm_x; }
  double get_shoulder_xz() const noexcept override { return scale_ * values_.shoulder_xz; }
  double get_shoulder_y() const noexcept override { return scale_ * values_.shoulder_y; }
  double get_shoulder_zz() const noexcept override { return scale_ * values_.shoulder_zz; }
  double get_slider_load() const noexcept override { return scale_ * values_.slider_load; }
  double get_trunk_mass() const noexcept override { return scale_ * values_.trunk_mass; }
  double get_trunk_x() const noexcept override { return scale_ * values_.trunk_x; }
  double get_trunk_xy() const noexcept override { return scale_ * values_.trunk_xy; }
  double get_size() const noexcept override { return scale_ * values_.size; }  // belongs to both interfaces

 private:
  ParameterValues values_;
  double scale_;
};

TEST(Update, TheDefaultsAreThoseOfTheDocument) {
  const ParameterValues values;
  EXPECT_EQ(values.trunk_mass, 6.0);
  EXPECT_EQ(values.lean, -0.2);
  EXPECT_EQ(values.size, 0.9);
  EXPECT_EQ(values.get_size(), 0.9);
  EXPECT_EQ(static_cast<const KinematicsParameters&>(values).get_size(), 0.9);
  EXPECT_EQ(static_cast<const DynamicsParameters&>(values).get_size(), 0.9);
  EXPECT_EQ(KinematicsValues().size, 0.9);
  EXPECT_EQ(DynamicsValues().size, 0.9);
  EXPECT_TRUE(same(Parameters<>(), Parameters<>(values)));
}

TEST(Update, OfOneInterfaceLeavesTheOthersValues) {
  const ParameterValues defaults, others = other_values<ParameterValues>();
  Parameters<> p;
  p.update(static_cast<const KinematicsParameters&>(others));
  EXPECT_TRUE(same(p, Parameters<>(others, defaults)));
  EXPECT_FALSE(same(p, Parameters<>()));
  EXPECT_EQ(p.values().upper, 0.5);
  EXPECT_EQ(p.values().trunk_mass, 6.0);
  p.update(static_cast<const DynamicsParameters&>(others));
  EXPECT_TRUE(same(p, Parameters<>(others)));
  ParameterValues masses_before = defaults;
  masses_before.size = others.size;
  p.update(static_cast<const DynamicsParameters&>(masses_before));
  EXPECT_TRUE(same(p, Parameters<>(others, defaults)));
}

// `size` moves the hand, and is a factor of masses.
TEST(Update, OfEitherInterfaceSetsWhatStandsInBoth) {
  // The hand in the frame of the arm, computed by way of the trunk: a few roundings.
  constexpr double kRounding = 1e-14;
  const auto hand = [](const Parameters<>& p) {
    namespace from = transforms::homogeneous;
    const Eigen::Matrix4d trunk_X_arm = from::fr_trunk_X_fr_arm(p, kQ);
    return (trunk_X_arm.inverse() * from::fr_trunk_X_hand(p, kQ))(1, 3);
  };
  const auto weight = [](const Parameters<>& p) { return gravity_forces(p, kQ)(0); };
  Parameters<> p;
  EXPECT_NEAR(hand(p), 0.09, kRounding);
  const double old_weight = weight(p);
  KinematicsValues kinematics;
  kinematics.size = 1.2;
  p.update(kinematics);
  EXPECT_NEAR(hand(p), 0.12, kRounding);
  EXPECT_NE(weight(p), old_weight);
  EXPECT_EQ(p.values().size, 1.2);
  ParameterValues grown;
  grown.size = 1.2;
  EXPECT_TRUE(same(p, Parameters<>(grown)));

  DynamicsValues dynamics;
  dynamics.size = 0.5;
  p.update(dynamics);
  EXPECT_NEAR(hand(p), 0.05, kRounding);
  grown.size = 0.5;
  EXPECT_TRUE(same(p, Parameters<>(grown)));

  p.update(kinematics, dynamics);
  EXPECT_EQ(p.values().size, 1.2);
}

TEST(Update, ListsWhatStandsInBothOnce) {
  EXPECT_EQ(std::count(kParameterNames.begin(), kParameterNames.end(), std::string("size")), 1);
}

TEST(Update, ReadsTheUsersOwnInterfaces) {
  const ParameterValues values = other_values<ParameterValues>();
  const Scaled same_values(values, 1), doubled(values, 2);
  EXPECT_TRUE(same(Parameters<>(same_values, same_values), Parameters<>(values)));
  Parameters<> p(values);
  p.update(same_values, doubled);
  EXPECT_EQ(p.values().trunk_mass, 15);
  EXPECT_EQ(p.values().upper, 0.5);
  EXPECT_EQ(p.values().size, values.size);  // both interfaces give it, and the kinematics one is used
}

TEST(Update, ValuesAndArraysGoThereAndBack) {
  const ParameterValues others = other_values<ParameterValues>();
  const Parameters<> p(others);
  EXPECT_TRUE(same(Parameters<>(p.values()), p));
  EXPECT_TRUE(same(Parameters<>(p.array()), p));
  for (std::size_t i = 0; i < kParameterNames.size(); ++i) {
    if (kParameterNames[i] == std::string("trunk_mass")) {
      EXPECT_EQ(p.array()[i], 7.5);
    }
  }
}

TEST(Update, ACopyIsAValue) {
  const Parameters<> original;
  const JointState before = inverse_dynamics(original, kQ, kQd, kQdd);
  Parameters<> copy = original;
  copy.update(other_values<ParameterValues>());
  EXPECT_EQ(inverse_dynamics(original, kQ, kQd, kQdd), before);
  EXPECT_NE(inverse_dynamics(copy, kQ, kQd, kQdd), before);
  copy = original;
  EXPECT_EQ(inverse_dynamics(copy, kQ, kQd, kQdd), before);
}

// Kinematics do not depend on masses.
TEST(Update, KinematicsDoNotReadDynamics) {
  Parameters<> p;
  const Eigen::Matrix4d before = transforms::homogeneous::fr_trunk_X_hand(p, kQ);
  ParameterValues others = other_values<ParameterValues>();
  others.size = ParameterValues().size;
  p.update(static_cast<const DynamicsParameters&>(others));
  EXPECT_EQ(transforms::homogeneous::fr_trunk_X_hand(p, kQ), before);
  p.update(static_cast<const KinematicsParameters&>(others));
  EXPECT_NE(transforms::homogeneous::fr_trunk_X_hand(p, kQ), before);
}

}  // namespace
}  // namespace robcogen::test::update_test
