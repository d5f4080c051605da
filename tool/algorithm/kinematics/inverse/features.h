// Features of a chain: points, directions and planes that some adjacent joints leave where they are. A feature has the
// same coordinates in all links between the first and the last of these joints.
#pragma once

#include <optional>
#include <vector>

#include "algorithm/kinematics/inverse/serial_chain.h"

namespace robcogen::algorithm::inversion {

struct Feature {
  enum class Kind {
    point,      // joints that turn about axes through it
    direction,  // joints that turn about it, and all that slide
    plane       // joints that turn about its normal, and those that slide in it
  };
  Kind kind = Kind::point;
  int begin = 0, end = 0;  // the joints that leave it in place, from begin to before end; none: of the base or the tool
  Numbers3 point{};        // of planes too
  Numbers3 direction{};    // the normal of planes
};

// The point in which the axes from begin to before end meet; nullopt if they are parallel or miss each other.
std::optional<Numbers3> common_point(const SerialChain& chain, int begin, int end);

// The distance by which the axes of two joints miss each other (m).
double gap(const ChainAxis& a, const ChainAxis& b);

// The point of an axis that is nearest to another axis.
Numbers3 foot(const ChainAxis& a, const ChainAxis& b);

// With maximal sets of joints, then with parts of these sets: two features that share a joint have no path between
// them.
struct Features {
  std::vector<Feature> maximal, all;
};
Features features_of(const SerialChain& chain);

}  // namespace robcogen::algorithm::inversion
