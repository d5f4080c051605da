#include "model/closed_positions.h"

#include <limits>

#include "model/loop_cluster.h"
#include "model/loop_plane.h"
#include "support/index.h"

namespace robcogen::model {

std::vector<double> closed_followers(
    const KinematicTree& tree,
    const std::vector<double>& q,
    const std::vector<double>& parameters) {
  constexpr int kSteps = 30;
  const std::vector<int> elements = tree.position_elements();
  std::vector<double> joints(tree.joints.size());
  for (const int follower : tree.followers_in_q())
    joints[at(follower)] = evaluate(tree.coupling_of(follower)->offset, parameters);
  for (const Closure& closure : tree.closures) {
    if (closure.method != Closure::Method::iterative) continue;
    const LoopCluster cluster(tree, closure.loops, parameters);
    double gap = 0.0;
    for (int step = 0; step <= kSteps; ++step) {
      for (const int joint : tree.coordinates()) {
        const double from = tree.joints[at(joint)].assembled_position(), to = q[at(elements[at(joint)])];
        joints[at(joint)] = step < kSteps ? from + (to - from) * step / kSteps : to;
      }
      gap = cluster.close(joints, closure.dependents);
    }
    if (!(gap <= kClosed * cluster.size(joints)))
      for (const int joint : closure.dependents) joints[at(joint)] = std::numeric_limits<double>::quiet_NaN();
  }
  std::vector<double> followers;
  for (const int follower : tree.followers_in_q()) followers.push_back(joints[at(follower)]);
  return followers;
}

}  // namespace robcogen::model
