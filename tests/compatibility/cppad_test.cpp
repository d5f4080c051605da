// A program for version 0.4 of the first RobCoGen that records its dynamics with CppAD: the derivatives are those of
// the library's own functions.
#include <cppad/cppad.hpp>

#include <gtest/gtest.h>
#include <cppad/example/cppad_eigen.hpp>

#include <vector>

#include "equal.h"
#include "floating_walker.h"

namespace robcogen::test {
namespace {

TEST(CppAd, Derivatives) {
  using Scalar = CppAD::AD<double>;
  const Eigen::Matrix<double, 9, 1> at = motion();
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> x = at.cast<Scalar>();
  CppAD::Independent(x);
  const Eigen::Matrix<Scalar, Eigen::Dynamic, 1> y = dynamics<Scalar>(x);
  CppAD::ADFun<double> recorded(x, y);
  const std::vector<double> jacobian = recorded.Jacobian(std::vector<double>(at.begin(), at.end()));
  const Eigen::Map<const Eigen::Matrix<double, 18, 9, Eigen::RowMajor>> derivatives(jacobian.data());
  expect_equal(derivatives, derivatives_of_dynamics());
}

}  // namespace
}  // namespace robcogen::test
