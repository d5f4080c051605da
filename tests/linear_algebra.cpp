#include "linear_algebra.h"

#include <Eigen/Dense>

namespace robcogen::test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd solved(const MatrixXd& A, const MatrixXd& b) {
  return A.partialPivLu().solve(b);
}

MatrixXd least_squares(const MatrixXd& A, const MatrixXd& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

int rank(const MatrixXd& A, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition(A);
  decomposition.setThreshold(threshold);
  return static_cast<int>(decomposition.rank());
}

double determinant(const MatrixXd& A) {
  return A.partialPivLu().determinant();
}

VectorXd singular_values(const MatrixXd& A) {
  return A.jacobiSvd().singularValues();
}

VectorXd eigenvalues(const MatrixXd& A) {
  return A.selfadjointView<Eigen::Lower>().eigenvalues();
}

}  // namespace robcogen::test
