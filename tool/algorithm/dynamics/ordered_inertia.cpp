#include "algorithm/dynamics/ordered_inertia.h"

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/elimination.h"

namespace robcogen::algorithm {

OrderedInertia::OrderedInertia(const model::KinematicTree& tree, const SquareMatrix& H)
    : order(elimination_tree(tree).order), a(H.size()) {
  const std::vector<std::string> all = coordinate_names(tree);
  for (const int k : order) names.push_back(all[at(k)]);
  for (int r = 0; r < H.size(); ++r)
    for (int c = 0; c < H.size(); ++c) a(r, c) = H(order[at(r)], order[at(c)]);
}

std::vector<Expression> OrderedInertia::ordered(const std::vector<Expression>& x) const {
  std::vector<Expression> result;
  for (const int k : order) result.push_back(x[at(k)]);
  return result;
}

std::vector<Expression> OrderedInertia::unordered(const std::vector<Expression>& x) const {
  std::vector<Expression> result(x.size());
  for (std::size_t r = 0; r < x.size(); ++r) result[at(order[r])] = x[r];
  return result;
}

}  // namespace robcogen::algorithm
