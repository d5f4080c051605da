// Merged products of primitive transforms, compared with products of 4 x 4 matrices.
#include "algorithm/kinematics/merged_primitives.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <random>

namespace robcogen::algorithm::merged_primitives_test {
namespace {

using model::Axis;
using model::PrimitiveTransform;
using model::Quantity;
using Primitives = std::vector<PrimitiveTransform>;

constexpr double kTolerance = 1e-13;  // about twenty factors of size 1

PrimitiveTransform rotation(Axis axis, const Quantity& angle) {
  return {true, axis, angle};
}
PrimitiveTransform translation(Axis axis, const Quantity& length) {
  return {false, axis, length};
}

const std::array kValues = {0.7, -1.3, 0.45};  // of the parameters, and of the variables

Eigen::Matrix4d product(const Primitives& primitives) {
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  for (const PrimitiveTransform& p : primitives) {
    const double amount = evaluate(p.amount, kValues, kValues);
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(static_cast<int>(p.axis));
    if (p.rotation)
      t = t * Eigen::AngleAxisd(amount, axis);
    else
      t = t * Eigen::Translation3d(amount * axis);
  }
  return t.matrix();
}

const Quantity kAngle = Quantity::variable(0), kOther = Quantity::variable(1), kLength = Quantity::parameter(0);
const Quantity kNumber = Quantity(0.25);

// Random products with few axes and amounts, so that neighbours often merge or cancel.
class RandomProducts : public testing::TestWithParam<unsigned> {
 protected:
  Primitives make() {
    std::mt19937 random(GetParam());
    const auto pick = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    const std::array amounts = {
        kNumber, -kNumber,          Quantity(1.5),           kAngle,    -kAngle, kOther, kAngle - kOther,
        kLength, kNumber - kLength, Quantity(2.0) * kLength, Quantity()};
    Primitives primitives;
    for (unsigned k = 2 + pick(10); k > 0; --k)
      primitives.push_back(
          {pick(2) == 0, static_cast<Axis>(pick(3)), amounts[pick(static_cast<unsigned>(amounts.size()))]});
    return primitives;
  }
};

TEST_P(RandomProducts, StayTheSame) {
  const Primitives before = make(), after = merged(before);
  EXPECT_TRUE(product(after).isApprox(product(before), kTolerance));
  EXPECT_LE(after.size(), before.size());
}

// No two neighbours could still be merged, and no primitive is the identity.
TEST_P(RandomProducts, LeaveNothingToMerge) {
  const Primitives after = merged(make());
  for (std::size_t k = 0; k < after.size(); ++k) {
    EXPECT_FALSE(after[k].amount.is_zero());
    if (k == 0) continue;
    EXPECT_FALSE(after[k].rotation == after[k - 1].rotation && after[k].axis == after[k - 1].axis) << k;
  }
  EXPECT_EQ(merged(after).size(), after.size());
}

INSTANTIATE_TEST_SUITE_P(, RandomProducts, testing::Range(0U, 200U));

TEST(MergedPrimitives, JoinAcrossWhatCommutes) {
  EXPECT_EQ(
      merged({translation(Axis::x, kLength), translation(Axis::y, kNumber), translation(Axis::x, kNumber)}).size(), 2U);
  EXPECT_EQ(merged({rotation(Axis::z, kAngle), translation(Axis::z, kLength), rotation(Axis::z, kNumber)}).size(), 2U);
}

TEST(MergedPrimitives, StayApartAcrossWhatDoesNot) {
  for (const PrimitiveTransform& barrier : {rotation(Axis::x, kOther), translation(Axis::x, kLength)})
    EXPECT_EQ(merged({rotation(Axis::z, kAngle), barrier, rotation(Axis::z, kNumber)}).size(), 3U);
  EXPECT_EQ(
      merged({translation(Axis::z, kLength), rotation(Axis::x, kAngle), translation(Axis::z, kLength)}).size(), 3U);
}

// Motion there and back: each pair that cancels makes the next pair neighbours.
TEST(MergedPrimitives, OppositeOnesVanishFromInsideOut) {
  EXPECT_TRUE(merged({rotation(Axis::x, kAngle), translation(Axis::y, kLength), rotation(Axis::y, kOther - kAngle),
                      rotation(Axis::y, kAngle - kOther), translation(Axis::y, -kLength), rotation(Axis::x, -kAngle)})
                  .empty());
}

TEST(MergedPrimitives, ConstantsAddUpExactly) {
  const Primitives sum = merged(
      {rotation(Axis::x, Quantity(Number::pi_multiple(1, 3)) + kAngle), rotation(Axis::x, -kAngle),
       rotation(Axis::x, Quantity(Number::pi_multiple(1, 6)))});
  ASSERT_EQ(sum.size(), 1U);
  ASSERT_TRUE(sum[0].amount.is_constant());
  EXPECT_EQ(sum[0].amount.number(), Number::pi_multiple(1, 2));
}

}  // namespace
}  // namespace robcogen::algorithm::merged_primitives_test
