// Loop joints, and how joints of the tree follow others through them (Featherstone 2008, ch. 8; Jain 2012).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "model/placement.h"

namespace robcogen::model {

// The constraint between the frames of the two ends. point: the origins coincide. hinge: the origins and the z axes
// coincide. slider: the frames agree except for a translation along z. weld: the frames coincide. distance: the
// distance of the origins is fixed.
enum class LoopType { point, hinge, slider, weld, distance };

// The keywords of the language, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> kLoopTypes = {"point", "hinge", "slider", "weld", "distance"};

// The frame at one end of a loop, fixed to a link.
struct LoopEnd {
  std::string frame;
  int link = -1;
  Placement placement;      // in the link frame
  std::vector<int> joints;  // from the last link that carries both ends, outwards
};

struct LoopJoint {
  std::string name;
  LoopType type = LoopType::point;
  std::array<LoopEnd, 2> ends;
  Quantity length;  // of LoopType::distance: m
  Place place;
  bool takes_other_branch = false;  // assembled on the branch opposite to the one drawn
};

// A joint that another joint follows, and the displacement of the follower per unit displacement of this joint.
struct LoopShare {
  int joint = -1;
  double factor = 0.0;
};

// How dependent joints follow the others of a loop.
struct Closure {
  // planar, distance: closed form for one loop. planar: all axes are parallel, and two dependent joints are found from
  // the sides of a triangle. distance: one joint is dependent.
  // iterative: several loops together, of any kind. The positions of the dependent joints are the last elements of q,
  // and Newton's method starts from there.
  enum class Method { planar, distance, iterative };
  std::vector<int> loops;
  Method method = Method::planar;
  std::vector<int> dependents;  // joints
  double branch = 1.0;          // the sign of the square root: how the loop is assembled
  // For a planar loop: two axes that span its plane, in the last link that carries both ends; and, by end and joint,
  // whether the joint turns about the normal of the plane (1), against it (-1), or slides (0).
  std::array<std::array<double, 3>, 2> plane = {};
  std::array<std::vector<int>, 2> senses = {};
  // For a parallelogram, by dependent joint: the shares whose sum the joint follows.
  std::vector<std::vector<LoopShare>> shares = {};

  // The only loop, or the first of those that are closed together.
  int loop() const { return loops.front(); }
};

}  // namespace robcogen::model
