#include "model/loop_ends.h"

#include <algorithm>

#include "support/index.h"

namespace robcogen::model {

std::vector<int> joints_from_base(const KinematicTree& tree, int link) {
  std::vector<int> joints;
  for (int j = tree.links[at(link)].parent_joint; j >= 0; j = tree.parent_joint_of(j)) joints.push_back(j);
  std::reverse(joints.begin(), joints.end());
  return joints;
}

std::array<LoopEnd, 2> ends_between(const KinematicTree& tree, const Frame& first, const Frame& second) {
  std::array<LoopEnd, 2> ends;
  for (std::size_t e = 0; e < 2; ++e) {
    const Frame& frame = e == 0 ? first : second;
    const int link = tree.link_of(frame);
    ends[e] = {frame.name, link, tree.placement_of(frame), joints_from_base(tree, link)};
  }
  const auto [a, b] =
      std::mismatch(ends[0].joints.begin(), ends[0].joints.end(), ends[1].joints.begin(), ends[1].joints.end());
  const auto common = a - ends[0].joints.begin();
  for (LoopEnd& end : ends) end.joints.erase(end.joints.begin(), end.joints.begin() + common);
  return ends;
}

}  // namespace robcogen::model
