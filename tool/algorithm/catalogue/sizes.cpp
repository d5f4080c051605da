#include "algorithm/catalogue/sizes.h"

#include <vector>

#include "support/index.h"

namespace robcogen::algorithm {

long pairs_of_coordinates(const model::KinematicTree& tree) {
  std::vector<long> carrying(tree.joints.size());
  long pairs = tree.floating_base ? 15 : 0;
  for (const int j : tree.topological()) {
    const int parent = tree.parent_joint_of(j);
    carrying[at(j)] = parent < 0 ? (tree.floating_base ? 6 : 0) : carrying[at(parent)] + 1;
    pairs += carrying[at(j)];
  }
  return pairs;
}

long operations_of_solutions(const model::KinematicTree& tree) {
  return 4 * pairs_of_coordinates(tree) * (3 * tree.dof() + (tree.floating_base ? 3 : 0));
}

long operations_of_inverse(const model::KinematicTree& tree) {
  return 4 * pairs_of_coordinates(tree) * (tree.dof() + (tree.floating_base ? 6 : 0));
}

long operations_of_base_solutions(const model::KinematicTree& tree) {
  const long joints = tree.dof();
  return tree.floating_base ? (3 * joints + 3) * (12 * joints + 72) : 0;
}

long operations_of_contact_solutions(
    const model::KinematicTree& tree,
    const std::vector<model::ContactFrame>& contacts) {
  const long base = tree.floating_base ? 6 : 0;
  long rows = 0, moved = 0;  // elements of J
  for (const model::ContactFrame& contact : contacts) {
    const long own = contact.is_surface ? 6 : 3;
    long carrying = base;
    for (int j = tree.links[at(tree.link_of(contact.frame))].parent_joint; j >= 0; j = tree.parent_joint_of(j))
      ++carrying;
    rows += own;
    moved += own * carrying;
  }
  const long columns = 3 * tree.dof() + base + rows;
  return columns * (4 * (pairs_of_coordinates(tree) + moved) + 2 * rows * rows);
}

bool are_long_solutions(long operations) {
  constexpr long kMany = 32'000;
  return operations > kMany;
}

bool are_better_in_columns(long operations) {
  constexpr long kMany = 12'000;
  return operations > kMany;
}

bool are_better_in_columns_for_base(long operations) {
  constexpr long kMany = 8'000;
  return operations > kMany;
}

}  // namespace robcogen::algorithm
