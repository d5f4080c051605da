#include "model/locked_loops.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/loop_cluster.h"
#include "model/loop_plane.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

// Groups loops whose clusters have joints in common.
std::vector<std::vector<int>> groups_of(const KinematicTree& open, const std::vector<double>& parameters) {
  std::vector<std::vector<int>> groups;
  for (std::size_t k = 0; k < open.loops.size(); ++k) {
    std::vector<int> group = {static_cast<int>(k)};
    const LoopCluster own(open, group, parameters);
    for (std::size_t g = groups.size(); g-- > 0;) {
      const LoopCluster other(open, groups[g], parameters);
      std::vector<int> common;
      std::set_intersection(
          own.joints().begin(), own.joints().end(), other.joints().begin(), other.joints().end(),
          std::back_inserter(common));
      if (common.empty()) continue;
      group.insert(group.begin(), groups[g].begin(), groups[g].end());
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(g));
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

// Moves the locked joints to their positions in small steps, while the others keep the loops closed.
void move_to(const LoopCluster& cluster, const std::vector<std::optional<double>>& targets, LockedGroup& group) {
  constexpr int kSteps = 50;
  const std::vector<double> start = group.positions;
  std::vector<double>& q = group.positions;
  for (int step = 1; step <= kSteps; ++step) {
    for (const int joint : group.locked) {
      const double from = start[at(joint)], to = *targets[at(joint)];
      q[at(joint)] = step < kSteps ? from + (to - from) * step / kSteps : to;
    }
    group.gap = cluster.close(q, cluster.following(q, group.joints));
  }
  group.is_closed = group.gap <= kClosed * cluster.size(q);
}

}  // namespace

std::vector<LockedGroup> locked_groups(
    const KinematicTree& tree,
    const KinematicTree& open,
    const std::vector<double>& start,
    const std::vector<std::optional<double>>& targets,
    const std::vector<double>& parameters) {
  std::vector<LockedGroup> result;
  for (std::vector<int>& loops : groups_of(open, parameters)) {
    const LoopCluster cluster(open, loops, parameters);
    LockedGroup group;
    for (const int joint : cluster.joints()) (targets[at(joint)] ? group.locked : group.joints).push_back(joint);
    if (group.locked.empty()) continue;
    // Joints that follow close the loops; the others stay where they are as far as possible.
    std::stable_partition(
        group.joints.begin(), group.joints.end(), [&](int joint) { return tree.coupling_of(joint) != nullptr; });
    std::sort(loops.begin(), loops.end());
    group.loops = std::move(loops);
    group.positions = start;
    move_to(cluster, targets, group);
    group.freedoms = static_cast<int>(group.joints.size() - cluster.following(group.positions, group.joints).size());
    group.is_rigid = group.freedoms == 0;
    result.push_back(std::move(group));
  }
  return result;
}

}  // namespace robcogen::model
