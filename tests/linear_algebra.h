// Decompositions for tests. They are compiled once, because Eigen's templates of them take seconds in each file.
#pragma once

#include <Eigen/Core>

namespace robcogen::test {

// x with A x = b, for a square matrix of full rank.
Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

// The shortest x of those with the least |A x - b|.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

// The number of pivots above the largest one times `threshold`.
int rank(const Eigen::MatrixXd& A, double threshold);

double determinant(const Eigen::MatrixXd& A);

// From the largest.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& A);

// Of a symmetric matrix, from the least.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& A);

}  // namespace robcogen::test
