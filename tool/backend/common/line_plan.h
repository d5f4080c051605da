// What becomes of a function's statements and inputs, decided before anything has a name.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "backend/common/block_plan.h"
#include "backend/common/lower.h"

namespace robcogen::backend {

// An element of an output that a statement supplies.
struct Store {
  std::size_t output = 0, element = 0;
  bool negative = false;
  int lane = -1;  // -1: the value is a scalar
};

// What becomes of a statement.
enum class Place {
  nowhere,  // no output needs it
  angle,    // a sine or cosine, defined with its pair
  inside,   // part of its only user's expression
  own,      // a definition
  sums,     // a definition of this sum of lanes and of the next one
  summed,   // defined with the sum before it
  output,   // stored without a name
  loaded,   // part of a block
};

// The argument of a sine or cosine, without its sign.
struct AngleKey {
  symbolic::Operand::Kind kind = symbolic::Operand::Kind::input;
  int index = 0;
  int lane = -1;  // a lane of a value; -1: the whole value
  friend auto operator<=>(const AngleKey&, const AngleKey&) = default;
};

inline AngleKey key_of(const symbolic::Operand& argument) {
  return {argument.kind, argument.index, argument.lane};
}

// Sine and cosine of one argument.
struct Angle {
  int first = -1;  // the first statement that needs it
  bool sine = false, cosine = false;
  std::string sine_name, cosine_name;  // set once values are named
};

struct LinePlan {
  // Indexed by statement.
  std::vector<Place> places = {};
  std::vector<int> users = {};  // the first user; -1: none
  std::vector<std::vector<Store>> stores = {};

  std::vector<int> widths = {};           // of values with lanes, ascending
  std::map<AngleKey, Angle> angles = {};  // a lane has an entry only if the whole value has none
  int first_together = 0;                 // index of an input element
  std::size_t together = 0;               // elements from there on with sines and cosines computed together; 0: none
  BlockPlan blocks = {};                  // empty if the dialect does not store outputs
  std::vector<bool> inputs_used = {};     // by flat index; false if loaded as part of a block

  // Whether a block or a fill stores this element.
  bool is_in_block(std::size_t output, std::size_t element) const {
    return !blocks.is_stored.empty() && blocks.is_stored[output][element];
  }
};

LinePlan line_plan(const symbolic::Program& program, const Dialect& dialect);

bool is_angle_function(symbolic::Op op);

}  // namespace robcogen::backend
