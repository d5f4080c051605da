// The collision shapes of a robot as spheres, inside spheres around a few of them, inside spheres around links: a check
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
  // A few spheres of a link that are near each other and are checked against the same shapes.
  struct Group {
    std::string name;  // of their bodies in the document, of which fixed joints may make one link
    Ball ball;         // contains its spheres
    int first = 0, count = 0;
  };
  struct Link {
    int link = -1;
    Ball ball;  // contains its groups
    int first = 0, count = 0;
  };
  // Two links, by their places in the list below, and the pairs of their groups that are checked.
  struct LinkPair {
    int a = 0, b = 0;
    int first = 0, count = 0;
  };

  std::vector<Sphere> spheres;  // those of a group are neighbours, and the groups of a link
  std::vector<Group> groups;
  std::vector<Link> links;  // that have shapes, parents first
  std::vector<LinkPair> link_pairs;
  std::vector<std::array<int, 2>> group_pairs;
  bool is_exact = true;  // all shapes are spheres
};

// The pairs are those of `collision_pairs`. A shape that is no sphere becomes a row of spheres that contain its capsule
// and reach at most an eighth of its radius beyond it, unless that takes more than 64.
CollisionTree collision_tree(const KinematicTree& tree);

// A sphere that contains all others, and is hardly larger than the smallest one. The coordinates of its centre are
// multiples of a micrometre, and its radius is rounded up to one.
Ball around(const std::vector<Ball>& balls);

}  // namespace robcogen::model
