// Rotations and their conjugations, compared with Eigen's dense matrices.
#include "algorithm/spatial/rotation.h"

#include <set>

#include "values.h"

namespace robcogen::algorithm::rotation_test {
namespace {

using test::flat;
using test::kTolerance;
using test::Numbers;

Eigen::Matrix3d matrix_of(const QuarterTurns& q) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) m(static_cast<int>(i), q.image[i]) = q.sign[i];
  return m;
}

TEST(QuarterTurn, IsTheRotationByItsAngle) {
  for (int axis = 0; axis < 3; ++axis)
    for (int turns = -9; turns <= 9; ++turns)
      EXPECT_TRUE(matrix_of(quarter_turn(axis, turns)).isApprox(test::turn(axis, turns * M_PI / 2), kTolerance))
          << axis << " " << turns;
}

// All 24 rotations of a cube are products of quarter turns about x, y and z.
TEST(QuarterTurn, ProductsAndInverses) {
  std::set<std::array<int, 6>> reached;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z) {
        const QuarterTurns q = quarter_turn(0, x) * quarter_turn(1, y) * quarter_turn(2, z);
        const Eigen::Matrix3d expected =
            test::turn(0, x * M_PI / 2) * test::turn(1, y * M_PI / 2) * test::turn(2, z * M_PI / 2);
        EXPECT_TRUE(matrix_of(q).isApprox(expected, kTolerance)) << x << y << z;
        EXPECT_EQ(matrix_of(inverse(q)), matrix_of(q).transpose());
        reached.insert({q.image[0], q.image[1], q.image[2], q.sign[0], q.sign[1], q.sign[2]});
      }
  EXPECT_EQ(reached.size(), 24u);
}

// Random rotations: quarter turns, followed by 0 to 4 planes.
class Rotations : public testing::TestWithParam<int> {
 protected:
  Numbers n{static_cast<unsigned>(GetParam())};
  Rotation rotation;
  Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();

  void SetUp() override {
    for (int axis = 0; axis < 3; ++axis) {
      const int turns = n.pick(4);
      rotation.quarter = rotation.quarter * quarter_turn(axis, turns);
      expected *= test::turn(axis, turns * M_PI / 2);
    }
    for (int k = n.pick(5); k > 0; --k) {
      const int axis = n.pick(3);
      const double angle = n.real();
      const Expression symbol = n.expression(angle);
      rotation.planes.push_back({axis, cos(symbol), sin(symbol)});
      expected *= test::turn(axis, angle);
    }
  }
};

TEST_P(Rotations, OfVectors) {
  const Vector3 v = n.vector();
  EXPECT_TRUE(n.value(to_parent(rotation, v)).isApprox(expected * n.value(v), kTolerance));
  EXPECT_TRUE(n.value(to_child(rotation, v)).isApprox(expected.transpose() * n.value(v), kTolerance));
}

TEST_P(Rotations, OfMatrices) {
  const Matrix3 general = n.matrix(), symmetric = n.symmetric();
  const Eigen::Matrix3d g = n.value(general), s = n.value(symmetric);
  EXPECT_TRUE(n.value(general_to_parent(rotation, general)).isApprox(expected * g * expected.transpose(), kTolerance));
  EXPECT_TRUE(
      n.value(general_to_parent(rotation, symmetric)).isApprox(expected * s * expected.transpose(), kTolerance));
  const Matrix3 turned = symmetric_to_parent(rotation, symmetric);
  EXPECT_TRUE(n.value(turned).isApprox(expected * s * expected.transpose(), kTolerance));
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(turned[r][c], turned[c][r]);
}

// Zeros of the matrix remain zeros in the formulas.
TEST_P(Rotations, OfSparseMatrices) {
  Matrix3 diagonal;
  for (std::size_t i = 0; i < 2; ++i) diagonal[i][i] = n.expression(n.real());
  const Eigen::Matrix3d d = n.value(diagonal);
  EXPECT_TRUE(
      n.value(symmetric_to_parent(rotation, diagonal)).isApprox(expected * d * expected.transpose(), kTolerance));
  EXPECT_TRUE(n.value(general_to_parent(rotation, diagonal)).isApprox(expected * d * expected.transpose(), kTolerance));
  EXPECT_TRUE(is_zero(to_parent(rotation, Vector3())));
}

INSTANTIATE_TEST_SUITE_P(, Rotations, testing::Range(0, 60));

TEST(Rotation, QuarterTurnsAreFree) {
  Numbers n;
  const Rotation turns{quarter_turn(0, 1) * quarter_turn(2, 3), {}};
  std::vector<Expression> all = flat(to_parent(turns, n.vector()));
  for (const Expression& e : flat(symmetric_to_parent(turns, n.symmetric()))) all.push_back(e);
  EXPECT_EQ(n.count(all).instructions, 0);
}

TEST(Rotation, APlaneCostsFourProductsAndTwoSums) {
  Numbers n;
  const Expression angle = n.expression(0.3);
  const symbolic::Cost c = n.count(flat(to_parent({{}, {{1, cos(angle), sin(angle)}}}, n.vector())));
  EXPECT_EQ(c.mul, 4);
  EXPECT_EQ(c.add, 2);
  EXPECT_EQ(c.sincos, 1);
}

// Doubled angles are computed once, even if they conjugate several matrices.
TEST(Rotation, ASecondConjugationSharesTheDoubledAngle) {
  Numbers n;
  const Expression angle = n.expression(0.3);
  const Rotation r{{}, {{2, cos(angle), sin(angle)}}};
  const Matrix3 first = symmetric_to_parent(r, n.symmetric()), second = symmetric_to_parent(r, n.symmetric());
  std::vector<Expression> both = flat(first);
  for (const Expression& e : flat(second)) both.push_back(e);
  // Both share s s, s c, 2 s c, 1 - 2 s s.
  EXPECT_LT(n.count(both).mul + n.count(both).add, 2 * (n.count(flat(first)).mul + n.count(flat(first)).add) - 2);
}

}  // namespace
}  // namespace robcogen::algorithm::rotation_test
