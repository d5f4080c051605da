// The joint-space inertia matrix in the order of its elimination.
#pragma once

#include <string>
#include <vector>

#include "algorithm/spatial/vectors.h"
#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

struct OrderedInertia {
  std::vector<int> order;          // by row: the row of H
  std::vector<std::string> names;  // of the rows
  SquareMatrix a;

  OrderedInertia(const model::KinematicTree& tree, const SquareMatrix& H);

  // Reorders a vector over the coordinates of H, and back.
  std::vector<Expression> ordered(const std::vector<Expression>& x) const;
  std::vector<Expression> unordered(const std::vector<Expression>& x) const;
};

}  // namespace robcogen::algorithm
