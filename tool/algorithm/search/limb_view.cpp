#include "algorithm/search/limb_view.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "support/index.h"

namespace robcogen::algorithm {

LimbView limb_view(const model::KinematicTree& tree, int joint, const std::vector<bool>& left_out) {
  std::vector<bool> kept(tree.joints.size(), false);
  for (int j = joint; j >= 0; j = tree.parent_joint_of(j)) kept[at(j)] = true;
  const std::function<void(int)> keep_beyond = [&](int j) {
    kept[at(j)] = true;
    for (const int child : tree.links[at(tree.joints[at(j)].child)].child_joints)
      if (left_out.empty() || !left_out[at(child)]) keep_beyond(child);
  };
  keep_beyond(joint);

  LimbView view;
  view.tree.name = tree.name;
  view.tree.floating_base = tree.floating_base;
  view.tree.uses_passive_forces = tree.uses_passive_forces;
  view.tree.parameters = tree.parameters;
  std::vector<int> new_link(tree.links.size(), -1);
  const auto add_link = [&](int link) {
    new_link[at(link)] = static_cast<int>(view.tree.links.size());
    view.tree.links.push_back(tree.links[at(link)]);
    view.tree.links.back().child_joints.clear();
    view.tree.links.back().parent_joint = -1;
  };
  add_link(0);
  for (const int j : tree.topological()) {
    if (!kept[at(j)]) continue;
    model::Joint copy = tree.joints[at(j)];
    add_link(copy.child);
    copy.parent = new_link[at(copy.parent)];
    copy.child = new_link[at(copy.child)];
    const int index = static_cast<int>(view.joints.size());
    view.tree.links[at(copy.parent)].child_joints.push_back(index);
    view.tree.links[at(copy.child)].parent_joint = index;
    view.tree.joints.push_back(std::move(copy));
    view.joints.push_back(j);
  }
  // A carrier that the view lacks is replaced by the base.
  for (model::Joint& copy : view.tree.joints)
    if (copy.drive.rotor) copy.drive.rotor->carrier = std::max(new_link[at(copy.drive.rotor->carrier)], 0);
  return view;
}

}  // namespace robcogen::algorithm
