// Joints that close loops: what they are, and how joints of the tree follow others through them (Featherstone 2008,
// ch. 8; Jain 2012).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "model/placement.h"

namespace robcogen::model {

// What stays the same between the frames of its two ends: that their origins coincide; these and their z axes, about
// which they may turn; all but how far one slides along the z axes; all; the distance of their origins.
enum class LoopType { point, hinge, slider, weld, distance };

// In the order of the enumeration: the word of the language.
inline constexpr std::array<std::string_view, 5> kLoopTypes = {"point", "hinge", "slider", "weld", "distance"};

// A frame of one end: it moves with the link.
struct LoopEnd {
  std::string frame;
  int link = -1;
  Placement placement;      // in the link frame
  std::vector<int> joints;  // from the last link that both ends are carried by, outwards
};

struct LoopJoint {
  std::string name;
  LoopType type = LoopType::point;
  std::array<LoopEnd, 2> ends;
  Quantity length;  // of LoopType::distance: m
  Place place;
  bool takes_other_branch = false;  // it is assembled the other way than next to where its joints are drawn
};

// A joint that another one follows, and how far that moves when it moves by one.
struct LoopShare {
  int joint = -1;
  double factor = 0.0;
};

// How dependent joints follow the others of a loop.
struct Closure {
  // In closed form, of one loop. planar: all axes are parallel, and two joints follow by the sides of a triangle.
  // distance: one joint follows.
  // iterative: of any loops together. The positions of joints that follow are elements of q, behind all others, and
  // Newton's method finds them from there.
  enum class Method { planar, distance, iterative };
  std::vector<int> loops;
  Method method = Method::planar;
  std::vector<int> dependents;  // joints
  double branch = 1.0;          // the sign of the square root: how the loop is assembled
  // Of a planar loop: two axes of its plane, in the last link that both ends are carried by, and whether each joint
  // turns about the third axis (1), against it (-1), or slides (0); by end and joint.
  std::array<std::array<double, 3>, 2> plane = {};
  std::array<std::vector<int>, 2> senses = {};
  // Of a parallelogram, by dependent joint: it follows by their sum.
  std::vector<std::vector<LoopShare>> shares = {};

  // The only one, or the first of those that are closed together.
  int loop() const { return loops.front(); }
};

}  // namespace robcogen::model
