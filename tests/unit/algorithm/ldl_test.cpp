// Elimination of a symmetric positive definite matrix, compared with Eigen.
#include "algorithm/dynamics/ldl.h"

#include "linear_algebra.h"
#include "values.h"

namespace robcogen::algorithm::ldl_test {
namespace {

TEST(Solve, SymmetricPositiveDefinite) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    test::Numbers n(seed);
    const int size = 1 + n.pick(6);
    Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return n.real(); });
    const Eigen::MatrixXd a = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(size, [&] { return n.real(); });
    SquareMatrix matrix(size);
    std::vector<Expression> right;
    for (int r = 0; r < size; ++r) {
      for (int c = 0; c <= r; ++c) matrix(r, c) = matrix(c, r) = n.expression(a(r, c));
      right.push_back(n.expression(b[r]));
    }
    const std::vector<double> x =
        test::evaluate(n.graph, n.inputs, solve(matrix, right, std::vector<std::string>(right.size(), "x")));
    const Eigen::VectorXd expected = robcogen::test::solved(a, b);
    const double scale = 1e-13 * a.norm();  // at least the condition number: the smallest eigenvalue is above 1
    EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(x.data(), size) - expected).norm(), scale) << "seed " << seed;
  }
}

// For a diagonal matrix, each element costs a division and a product; zeros stay zero.
TEST(Solve, ZerosCostNothing) {
  test::Numbers n;
  SquareMatrix a(3);
  std::vector<Expression> b(3);
  for (int i = 0; i < 3; ++i) a(i, i) = n.expression(2.0);
  b[1] = n.expression(3.0);
  const std::vector<Expression> x = solve(a, b, {"x", "y", "z"});
  EXPECT_TRUE(x[0].is_zero());
  EXPECT_TRUE(x[2].is_zero());
  EXPECT_EQ(n.value(x[1]), 1.5);
  EXPECT_EQ(n.count(x).mul + n.count(x).add, 1);
}

}  // namespace
}  // namespace robcogen::algorithm::ldl_test
