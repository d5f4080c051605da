// What collision checks need of the shapes of a robot: capsules, and the pairs of them that are checked.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Functions of distances exist for at most as many pairs: code without loops has the distance of each.
constexpr std::size_t kMaxCollisionPairs = 4000;

// The points within `radius` (m) of a segment. A sphere is a capsule whose ends coincide.
struct Capsule {
  std::string name;  // of its body, with a number if the body has several
  std::string body;  // Shape::body
  int link = -1;
  std::array<std::array<double, 3>, 2> ends = {};  // in the frame of the link, m
  double radius = 0;

  bool is_sphere() const { return ends[0] == ends[1]; }
};

// One for each collision shape, in order: a sphere and a capsule are themselves. Cylinders, boxes and meshes are inside
// theirs: a cylinder has the same axis and radius, and of the capsules along the axes of a box or a mesh, the one with
// the least volume is taken. An axis of less than a micrometre becomes a point, and its capsule a sphere that contains
// it: its square would be too small to divide by in single precision.
std::vector<Capsule> capsules(const KinematicTree& tree);

// The pairs of these capsules, first index first, whose distance changes: of different links. With an SRDF, all but
// those that it disables; otherwise all but those of links that a joint connects, one that closes a loop included.
// Those that the document itself excludes are left out in either case.
std::vector<std::array<std::size_t, 2>> collision_pairs(
    const KinematicTree& tree,
    const std::vector<Capsule>& capsules);

}  // namespace robcogen::model
