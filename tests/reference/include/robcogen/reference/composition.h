// Identities between coordinate transforms, for any factors.
#pragma once

#include <vector>

#include "robcogen/reference/algebra.h"
#include "robcogen/reference/checks.h"
#include "robcogen/reference/subject.h"

namespace robcogen::reference {

inline constexpr Tolerance kTransform{
    "kTransform", 1e-13, "rounding of a product of rotations, relative to the lengths"};

// The error relative to the lengths in the matrix, and to one, the size of its rotation.
template <class Scalar>
Real transform_error(const Matrix<double>& actual, const Matrix<Scalar>& expected) {
  const Matrix<Real> wanted = expected.template cast<Real>();
  return largest(actual.cast<Real>() - wanted) / std::max(Real(1), largest(wanted));
}

// The frames of left_X_right.
struct FramePair {
  int left;
  int right;
};

// Checks that the three forms represent one transform.
inline void check_duality(const TransformForms& X, int sample, Checks& checks) {
  checks.record(
      "P5: motion form of the homogeneous one", kTransform, transform_error(X.motion, motion_form(X.homogeneous)),
      sample);
  const Real lengths = std::max(1.0, largest(X.motion) * largest(X.force));
  checks.record(
      "P5: force = inverse transpose of motion", kTransform,
      transform_error(transpose(X.force) * X.motion, Matrix<double>::identity(6)) / lengths, sample);
}

// Checks left_X_middle * middle_X_right = left_X_right wherever all three are given, and inverse pairs.
inline void check_composition(
    const std::vector<FramePair>& pairs,
    const std::vector<TransformForms>& all,
    int sample,
    Checks& checks) {
  const TransformForms unit{Matrix<double>::identity(4), Matrix<double>::identity(6), Matrix<double>::identity(6)};
  for (std::size_t a = 0; a < pairs.size(); ++a) {
    for (std::size_t b = 0; b < pairs.size(); ++b) {
      if (pairs[a].right != pairs[b].left) continue;
      const auto compare = [&](const char* name, const TransformForms& expected) {
        const TransformForms product = all[a] * all[b];
        const Real lengths = std::max(1.0, largest(all[a].motion) * largest(all[b].motion));
        const Real error = worst_of(
            {transform_error(product.homogeneous, expected.homogeneous),
             transform_error(product.motion, expected.motion), transform_error(product.force, expected.force)});
        checks.record(name, kTransform, error / lengths, sample);
      };
      if (pairs[a].left == pairs[b].right) compare("P5: inverse pairs", unit);
      for (std::size_t k = 0; k < pairs.size(); ++k)
        if (pairs[k].left == pairs[a].left && pairs[k].right == pairs[b].right) compare("P5: composition", all[k]);
    }
  }
}

}  // namespace robcogen::reference
