#include "model/limbs.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "support/index.h"

namespace robcogen::model {

namespace {

bool is_on_way(const KinematicTree& tree, int joint, int link) {
  for (int l = link; tree.links[at(l)].parent_joint >= 0; l = tree.joints[at(tree.links[at(l)].parent_joint)].parent)
    if (tree.links[at(l)].parent_joint == joint) return true;
  return false;
}

// The joints that move the carrier of the joint's rotor and do not carry the joint.
std::vector<int> joints_of_rotor(const KinematicTree& tree, std::size_t joint) {
  std::vector<int> joints;
  const std::optional<Rotor>& rotor = tree.joints[joint].drive.rotor;
  int carrier = rotor ? tree.links[at(rotor->carrier)].parent_joint : -1;
  for (; carrier >= 0 && !is_on_way(tree, carrier, tree.joints[joint].parent); carrier = tree.parent_joint_of(carrier))
    joints.push_back(carrier);
  return joints;
}

}  // namespace

std::vector<int> limb_shapes(const KinematicTree& tree) {
  std::vector<bool> is_tied(tree.joints.size(), false);
  for (const Coupling& coupling : tree.couplings) {
    is_tied[at(coupling.joint)] = true;
    for (const Coupling::Term& term : coupling.terms) is_tied[at(term.joint)] = true;
  }
  // A rotor beyond its joint stays within a limb; one on another branch ties the two.
  std::vector<std::size_t> distance(tree.joints.size());  // of rotors from their joints
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const std::vector<int> joints = joints_of_rotor(tree, j);
    distance[j] = joints.size();
    if (joints.empty() || joints.back() == static_cast<int>(j)) continue;
    is_tied[j] = true;
    for (const int joint : joints) is_tied[at(joint)] = true;
  }
  constexpr int kUntied = -1;
  std::map<std::tuple<JointType, bool, std::vector<bool>, int, std::vector<int>>, int> known;
  std::vector<int> shape(tree.joints.size(), -1);
  const std::vector<int> order = tree.topological();
  for (auto joint = order.rbegin(); joint != order.rend(); ++joint) {
    std::vector<int> beyond;
    for (int child : tree.links[at(tree.joints[at(*joint)].child)].child_joints) beyond.push_back(shape[at(child)]);
    std::sort(beyond.begin(), beyond.end());
    const auto number = static_cast<int>(known.size());
    const Joint& own = tree.joints[at(*joint)];
    const int tied = is_tied[at(*joint)] ? *joint : kUntied;
    std::vector<bool> drive = own.drive.present(tree.uses_passive_forces);
    drive.resize(drive.size() + distance[at(*joint)]);
    shape[at(*joint)] =
        known.try_emplace({own.type, own.pitch.is_zero(), std::move(drive), tied, std::move(beyond)}, number)
            .first->second;
  }
  return shape;
}

std::vector<int> limb_joints(const KinematicTree& tree, const std::vector<int>& shapes, int first) {
  std::vector<int> joints, pending = {first};
  while (!pending.empty()) {
    const int joint = pending.back();
    pending.pop_back();
    joints.push_back(joint);
    std::vector<int> children = tree.links[at(tree.joints[at(joint)].child)].child_joints;
    std::stable_sort(children.begin(), children.end(), [&](int a, int b) { return shapes[at(a)] < shapes[at(b)]; });
    pending.insert(pending.end(), children.rbegin(), children.rend());
  }
  return joints;
}

std::vector<int> LimbClass::corresponding(std::size_t k) const {
  std::vector<int> joints;
  for (const std::vector<int>& limb : limbs) joints.push_back(limb[k]);
  return joints;
}

std::vector<LimbClass> limb_classes(const KinematicTree& tree) {
  const std::vector<int> shape = limb_shapes(tree);
  std::vector<LimbClass> classes;
  std::vector<int> links = {0};
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::vector<int>& children = tree.links[at(links[i])].child_joints;
    std::map<int, int> count, place;  // by shape: of limbs; among the classes
    for (int joint : children) ++count[shape[at(joint)]];
    for (int joint : children) {
      if (count[shape[at(joint)]] == 1) {
        links.push_back(tree.joints[at(joint)].child);
        continue;
      }
      const auto [known, fresh] = place.try_emplace(shape[at(joint)], static_cast<int>(classes.size()));
      if (fresh) classes.emplace_back();
      classes[at(known->second)].limbs.push_back(limb_joints(tree, shape, joint));
    }
  }
  return classes;
}

std::vector<std::vector<int>> corresponding_joints(const KinematicTree& tree) {
  std::vector<std::vector<int>> groups;
  for (const LimbClass& limbs : limb_classes(tree))
    for (std::size_t k = 0; k < limbs.length(); ++k) groups.push_back(limbs.corresponding(k));
  return groups;
}

}  // namespace robcogen::model
