// Kinematic trees that are put together by hand, without checks.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model::test {

inline std::array<Quantity, 3> vector(double x, double y, double z) {
  return {Quantity(x), Quantity(y), Quantity(z)};
}

inline Inertia body(double mass, const std::array<double, 3>& com = {}, const std::array<double, 6>& inertia = {}) {
  Inertia result;
  result.mass = Quantity(mass);
  result.com = vector(com[0], com[1], com[2]);
  Quantity* const elements[] = {&result.ixx, &result.iyy, &result.izz, &result.ixy, &result.ixz, &result.iyz};
  for (std::size_t k = 0; k < 6; ++k) *elements[k] = Quantity(inertia[k]);
  return result;
}

// A robot that consists of its base.
inline KinematicTree only_base(const std::string& robot, const std::string& base, bool floating_base = false) {
  KinematicTree tree;
  tree.name = robot;
  tree.floating_base = floating_base;
  tree.links.emplace_back();
  tree.links[0].name = base;
  return tree;
}

// Adds a joint and the link that it carries.
inline void add_link(
    KinematicTree& tree,
    const std::string& joint,
    JointType type,
    int parent,
    const std::string& link,
    std::optional<Inertia> inertia = std::nullopt,
    const std::array<Quantity, 3>& translation = {}) {
  const int index = static_cast<int>(tree.joints.size()), child = static_cast<int>(tree.links.size());
  Link added;
  added.name = link;
  added.inertia = std::move(inertia);
  added.parent_joint = index;
  tree.links.push_back(std::move(added));
  tree.links[static_cast<std::size_t>(parent)].child_joints.push_back(index);
  Joint made;
  made.name = joint;
  made.type = type;
  made.parent = parent;
  made.child = child;
  made.placement.translation = translation;
  tree.joints.push_back(std::move(made));
}

inline void add_frame(
    KinematicTree& tree,
    const std::string& name,
    int link,
    const std::array<Quantity, 3>& translation = {}) {
  UserFrame frame;
  frame.name = name;
  frame.link = link;
  frame.placement.translation = translation;
  tree.user_frames.push_back(std::move(frame));
}

}  // namespace robcogen::model::test
