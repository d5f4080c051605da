// The pivots of a loop in a plane, and their positions.
#pragma once

#include <array>
#include <vector>

#include "algorithm/spatial/triangle.h"
#include "model/loop.h"

namespace robcogen::algorithm {

class Trace;

// A joint, or the end of the loop behind the last joint, in the plane at q = 0.
struct Pivot {
  int joint = -1;
  int sense = 0;  // 1, -1; 0 for a joint that slides
  bool is_dependent = false;
  Vector2 step;            // from the pivot before
  Vector2 direction = {};  // of a joint that slides
};

// By end, from the last link that carries both ends outwards. The last pivot is the point that closes the loop.
using PlanarLoop = std::array<std::vector<Pivot>, 2>;

PlanarLoop planar_loop(Trace& trace, const model::Closure& closure);

// Pivots of one end whose joints are at q (by joint); positions of dependent joints need not be known.
struct PlanarChain {
  symbolic::Graph& graph;
  const std::vector<Pivot>& pivots;
  const std::vector<symbolic::Expression>& q;

  // The turn by the joints from `first` up to, but without, `last` that do not follow others.
  Vector2 turn(std::size_t first, std::size_t last) const;
  // The vector from a pivot to another one behind it, in the axes behind the first; both may follow others, no joint
  // between does. `first` is -1 for the origin of the plane.
  Vector2 reach(int first, std::size_t last) const;
};

// One end of a loop when all positions are known.
struct Posture {
  std::vector<Vector2> origins;     // of the pivots
  std::vector<Vector2> directions;  // of joints that slide
  std::vector<Vector2> steps;       // from each pivot to the next one
};

Posture posture(const PlanarChain& chain);

}  // namespace robcogen::algorithm
