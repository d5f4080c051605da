// Conversion of rotations to roll, pitch and yaw is as exact as the turns that they consist of.
#include "export/pose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace robcogen::exporting::pose_test {
namespace {

using Rotation = Eigen::Matrix<Real, 3, 3>;
using Angles = std::array<double, 3>;

constexpr double kQuarter = std::numbers::pi / 2;

Number quarters(std::int64_t count) {
  return Number::pi_multiple(count, 2);
}

Pose pose(const Number& x, const Number& y, const Number& z) {
  model::Placement placement;
  placement.rotation = {model::Quantity(x), model::Quantity(y), model::Quantity(z)};
  return pose_of(placement);
}

Angles angles(const Number& x, const Number& y, const Number& z) {
  return roll_pitch_yaw(pose(x, y, z));
}

// The angle that a number stands for, in long double.
Real exact(const Number& angle) {
  if (!angle.is_pi_multiple()) return angle.value();
  return std::numbers::pi_v<Real> * Real(angle.ratio()->num) / Real(angle.ratio()->den);
}

Rotation turn(Real angle, int axis) {
  return Eigen::AngleAxis<Real>(angle, Eigen::Matrix<Real, 3, 1>::Unit(axis)).toRotationMatrix();
}

Rotation from_roll_pitch_yaw(const Angles& a) {
  return turn(a[2], 2) * turn(a[1], 1) * turn(a[0], 0);
}

TEST(RollPitchYaw, OfOneTurnIsThatTurn) {
  for (const Number& a :
       {Number(), Number(0.3), Number(-1e-9), Number(4.0), quarters(1), quarters(-1), quarters(2), quarters(3),
        Number::pi_multiple(2, 3), Number(kQuarter)}) {
    EXPECT_EQ(angles(a, {}, {}), (Angles{a.value(), 0, 0}));
    EXPECT_EQ(angles({}, a, {}), (Angles{0, a.value(), 0}));
    EXPECT_EQ(angles({}, {}, a), (Angles{0, 0, a.value()}));
  }
}

// Rx(PI/2) maps the y and z axes of the following turns to z and -y.
TEST(RollPitchYaw, OfATurnAfterAQuarterTurnIsExact) {
  for (const double a : {0.3, -0.7, 1.1, 0.001, -1e-12}) {
    EXPECT_EQ(angles(quarters(1), Number(a), {}), (Angles{kQuarter, 0, a})) << a;
    EXPECT_EQ(angles(quarters(1), {}, Number(a)), (Angles{kQuarter, -a, 0})) << a;
    EXPECT_EQ(angles(quarters(-1), Number(a), {}), (Angles{-kQuarter, 0, -a})) << a;
    EXPECT_EQ(angles(Number(a), {}, quarters(2)), (Angles{-a, 0, quarters(2).value()})) << a;
  }
}

// Rx(PI/2) Ry(a) Rz(PI/2) maps x to z, so only the sum of roll and yaw is determined.
TEST(RollPitchYaw, AtAPitchOfAQuarterTurnHasNoRoll) {
  for (const double a : {0.3, -0.7, 1.25, 0.001}) {
    const auto [no_roll, down, yaw_down] = angles(quarters(1), Number(a), quarters(1));
    EXPECT_EQ(no_roll, 0.0);
    EXPECT_EQ(down, -kQuarter);
    EXPECT_DOUBLE_EQ(yaw_down, kQuarter + a);
    // The double nearest to PI/2 is off by 6e-17, too little to determine the roll.
    EXPECT_EQ(angles(Number(kQuarter), Number(a), Number(kQuarter)), (Angles{0, -kQuarter, yaw_down})) << a;
    const auto [none, up, yaw_up] = angles(quarters(-1), Number(a), quarters(1));
    EXPECT_EQ(none, 0.0);
    EXPECT_EQ(up, kQuarter);
    EXPECT_DOUBLE_EQ(yaw_up, kQuarter - a);
  }
}

TEST(RollPitchYaw, OfQuarterTurnsAreQuarterTurns) {
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        const Angles found = angles(quarters(x), quarters(y), quarters(z));
        for (const double angle : found) EXPECT_EQ(angle, quarters(std::lround(angle / kQuarter)).value());
        const Rotation expected = turn(x * kQuarter, 0) * turn(y * kQuarter, 1) * turn(z * kQuarter, 2);
        constexpr Real kOneRounding = 1e-15L;  // rounding PI/2 to a double, in up to six turns
        EXPECT_LT((from_roll_pitch_yaw(found) - expected).cwiseAbs().maxCoeff(), kOneRounding);
      }
    }
  }
}

// Returns an angle at which formulas break: a quarter turn, one near it, PI/2 as documents spell it, or any angle.
Number odd_angle(std::mt19937_64& engine) {
  const auto below = [&](std::uint64_t n) { return static_cast<std::int64_t>(engine() % n); };
  const double any = static_cast<double>(engine() >> 11) * 0x1p-53 * 6 - 3;
  switch (below(6)) {
    case 0:
      return quarters(below(5) - 2);
    case 1:
      return Number::pi_multiple(below(25) - 12, 12);
    case 2:
      return Number(kQuarter * static_cast<double>(below(5) - 2));
    case 3:
      return Number(1.5707963);
    case 4:
      return Number(kQuarter + any * std::pow(10.0, -static_cast<double>(below(17))));
    default:
      return Number(any);
  }
}

// Three angles are rounded to doubles, each with an error of up to 2.2e-16 rad.
constexpr Real kRounding = 8e-16L;

TEST(RollPitchYaw, IsAccurateForAnyTurns) {
  std::mt19937_64 engine(4);
  for (int i = 0; i < 20000; ++i) {
    Pose all;
    Rotation expected = Rotation::Identity();
    for (int placements = 0; placements < 1 + i % 3; ++placements) {
      const Number x = odd_angle(engine), y = odd_angle(engine), z = odd_angle(engine);
      all = all * pose(x, y, z);
      expected = expected * turn(exact(x), 0) * turn(exact(y), 1) * turn(exact(z), 2);
    }
    const Angles found = roll_pitch_yaw(all);
    const Real error = (from_roll_pitch_yaw(found) - expected).cwiseAbs().maxCoeff();
    ASSERT_LT(error, kRounding) << i << ": " << found[0] << ", " << found[1] << ", " << found[2];
  }
}

TEST(Pose, TimesItsInverseIsTheIdentity) {
  std::mt19937_64 engine(5);
  for (int i = 0; i < 100; ++i) {
    Pose p = pose(odd_angle(engine), odd_angle(engine), odd_angle(engine));
    p.translation = {0.5L, -0.25L, 1.0L};
    EXPECT_TRUE((p * inverse_of(p)).turns.empty());
    for (const Real x : (p * inverse_of(p)).translation) EXPECT_LT(std::abs(x), 1e-18L);
  }
}

TEST(Pose, OfQuarterTurnsMovesPointsExactly) {
  Pose p = pose(quarters(1), quarters(1), quarters(-1));
  p.translation = {1, 2, 3};
  EXPECT_EQ((p * inverse_of(p)).translation, Vector3{});
  EXPECT_TRUE((p * inverse_of(p)).is_identity());
}

}  // namespace
}  // namespace robcogen::exporting::pose_test
