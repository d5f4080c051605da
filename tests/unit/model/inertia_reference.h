// The joint-space inertia matrix of a description from body Jacobians, in plain matrices: an independent check for
// tests.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "descriptions.h"

namespace robcogen::model::test {

// H(q), base first, as the sum of J' I J over the bodies, with Jacobians in world axes about the centre of mass.
Eigen::MatrixXd inertia_matrix(const Description& d, const std::vector<int>& parents, const Eigen::VectorXd& q);

// The number of zero eigenvalues of a symmetric matrix whose numbers are of order one or zero.
int nullity(const Eigen::MatrixXd& H);

}  // namespace robcogen::model::test
