#include "algorithm/dynamics/elimination.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "algorithm/spatial/couplings.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;

constexpr int kBase = 6;

// By joint: the coordinates that move it.
std::vector<std::vector<int>> movers(const KinematicTree& tree) {
  std::vector<std::vector<int>> result;
  for (int joint = 0; joint < static_cast<int>(tree.joints.size()); ++joint)
    result.push_back(coordinates_of(tree, {joint}));
  return result;
}

// By coordinate: the place of the first joint that it moves in the topological order.
std::vector<int> first_places(const KinematicTree& tree, const std::vector<std::vector<int>>& moved_by) {
  std::vector<int> places(at(tree.dof()), std::numeric_limits<int>::max());
  int place = 0;
  for (const int joint : tree.topological()) {
    for (const int coordinate : moved_by[at(joint)]) places[at(coordinate)] = std::min(places[at(coordinate)], place);
    ++place;
  }
  return places;
}

// By coordinate: the others with which it has an element in H, because one of the two moves a joint that carries a
// joint of the other, or the same joint, or the carrier of its rotor.
std::vector<std::set<int>> neighbours(const KinematicTree& tree, const std::vector<std::vector<int>>& moved_by) {
  std::vector<std::set<int>> result(at(tree.dof()));
  const auto tie = [&](int joint, int carrying) {
    for (int carrier = carrying; carrier >= 0; carrier = tree.parent_joint_of(carrier)) {
      for (const int own : moved_by[at(joint)]) {
        for (const int other : moved_by[at(carrier)]) {
          result[at(own)].insert(other);
          result[at(other)].insert(own);
        }
      }
    }
  };
  for (const int joint : tree.topological()) {
    tie(joint, joint);
    if (const std::optional<model::Rotor>& rotor = tree.joints[at(joint)].drive.rotor)
      tie(joint, tree.links[at(rotor->carrier)].parent_joint);
  }
  return result;
}

}  // namespace

EliminationTree elimination_tree(const KinematicTree& tree) {
  const int base = tree.floating_base ? kBase : 0;
  const std::vector<std::vector<int>> moved_by = movers(tree);
  const std::vector<int> places = first_places(tree, moved_by);
  std::vector<int> coordinates;
  for (int k = 0; k < tree.dof(); ++k) coordinates.push_back(k);
  std::stable_sort(coordinates.begin(), coordinates.end(), [&](int a, int b) { return places[at(a)] < places[at(b)]; });
  std::vector<int> rank(coordinates.size());
  for (std::size_t i = 0; i < coordinates.size(); ++i) rank[at(coordinates[i])] = static_cast<int>(i);

  // The nearest neighbour that is eliminated later is the parent in the elimination tree; it inherits the others.
  std::vector<std::set<int>> earlier(coordinates.size());  // by rank
  const std::vector<std::set<int>> tied = neighbours(tree, moved_by);
  for (std::size_t k = 0; k < tied.size(); ++k)
    for (const int other : tied[k])
      if (rank[at(other)] < rank[k]) earlier[at(rank[k])].insert(rank[at(other)]);
  std::vector<int> parents(coordinates.size(), -1);
  for (std::size_t i = coordinates.size(); i-- > 0;) {
    if (earlier[i].empty()) continue;
    parents[i] = *earlier[i].rbegin();
    earlier[i].erase(parents[i]);
    earlier[at(parents[i])].insert(earlier[i].begin(), earlier[i].end());
  }

  EliminationTree result;
  result.ancestors.resize(at(base + tree.dof()));
  for (int k = 0; k < base; ++k) {
    for (int b = 0; b < k; ++b) result.ancestors[at(k)].push_back(b);
    result.order.push_back(k);
  }
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    std::vector<int>& ancestors = result.ancestors[at(base + coordinates[i])];
    if (parents[i] >= 0) {
      const int parent = base + coordinates[at(parents[i])];
      ancestors = result.ancestors[at(parent)];
      ancestors.push_back(parent);
    } else {
      for (int b = 0; b < base; ++b) ancestors.push_back(b);
    }
    result.order.push_back(base + coordinates[i]);
  }
  return result;
}

}  // namespace robcogen::algorithm
