// The collision shapes of a robot as spheres, inside spheres around a few of them, inside spheres around parts: a check
// whether anything is hit ends early where a sphere that contains others is far away.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

struct Ball {
  std::array<double, 3> center = {};  // in the frame of the link, m
  double radius = 0;
};

struct CollisionTree {
  struct Sphere {
    std::string name;  // Capsule::name
    Ball ball;
  };
  // A few spheres of a part that are near each other.
  struct Group {
    std::string name;  // of their bodies in the document, of which fixed joints may make one link
    Ball ball;         // contains its spheres
    int first = 0, count = 0;
  };
  // The shapes of a link that are checked against the same others: all of them, as a rule.
  struct Part {
    int link = -1;
    Ball ball;  // contains its groups
    int first = 0, count = 0;
  };

  std::vector<Sphere> spheres;  // those of a group are neighbours, and the groups of a part
  std::vector<Group> groups;
  std::vector<Part> parts;                // those of a link after those of its parent
  std::vector<std::array<int, 2>> pairs;  // of parts, whose shapes are all checked against each other
  bool is_exact = true;                   // all shapes are spheres
};

// The pairs are those of `collision_pairs`. A shape that is no sphere becomes a row of spheres that contain its capsule
// and reach at most an eighth of its radius beyond it, unless that takes more than 64.
CollisionTree collision_tree(const KinematicTree& tree);

// A sphere that contains all others, and is hardly larger than the smallest one. The coordinates of its centre are
// multiples of a micrometre, and its radius is rounded up to one.
Ball around(const std::vector<Ball>& balls);

}  // namespace robcogen::model
