// The lines of a lowered function before they are written: which statements are lines of their own, where their values
// go, and how each is spelled.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "backend/common/block_plan.h"
#include "backend/common/lower.h"

namespace robcogen::backend {

// An element of an output that a statement supplies.
struct Store {
  std::string target;
  std::size_t output = 0;
  bool negative = false;
  int lane = -1;  // -1: of a scalar
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
  int lane = -1;  // of a value with lanes: this one; -1: the whole
  friend auto operator<=>(const AngleKey&, const AngleKey&) = default;
};

inline AngleKey key_of(const symbolic::Operand& argument) {
  return {argument.kind, argument.index, argument.lane};
}

// Sine and cosine of one argument.
struct Angle {
  int first = -1;  // statement that asks for it first
  bool sine = false, cosine = false;
  std::string sine_name, cosine_name;
};

struct Arrangement {
  const symbolic::Program& program;
  const Dialect& dialect;
  NameScope scope;
  std::vector<Parameter> parameters = {};
  std::vector<int> widths = {};                 // of values with lanes, ascending
  std::vector<Line> bindings = {};              // by Dialect::binds_parameters
  std::vector<std::string> input_names = {};    // by flat index: `q[1]`
  std::vector<std::string> input_sources = {};  // by flat index: what this text refers to: the array, or a binding
  Texts texts = {};                             // of spellings; those of names are where these are
  std::vector<Spelling> constants = {};
  // By statement.
  std::vector<Place> places = {};
  std::vector<std::string> names = {};
  std::vector<Spelling> spellings = {};    // how a user reads the statement, unless it stands inside
  std::vector<Spelling> expressions = {};  // what it is: stands in its line, or inside its user
  std::vector<std::vector<Store>> stores = {};
  std::map<AngleKey, Angle> angles = {};  // of a lane only where there is none of the whole value
  int first_together = 0;                 // input element
  std::size_t together = 0;               // how many from it on have their sines and cosines computed together; 0: none
  BlockPlan blocks = {};
  std::vector<std::string> load_names = {};
};

Arrangement arrange(const symbolic::Program& program, const Dialect& dialect);

// Of a statement whose operands have their spellings.
Spelling expression(Arrangement& arranged, std::size_t statement);

// As the function reads it, and as an operand of a statement of so many lanes.
Spelling spell(Arrangement& arranged, const symbolic::Operand& o);
Spelling spell(Arrangement& arranged, const symbolic::Operand& o, int lanes);
Spelling lane_of(Arrangement& arranged, Spelling value, int lane);

// The line of a statement that is not inside another; of one that is, the line that it would have by itself.
Line line(const Arrangement& arranged, std::size_t statement);

// What the text of an operand in so many lanes, and that of a statement's line, refers to: Line::names.
void add_names(const Arrangement& arranged, const symbolic::Operand& o, int lanes, std::vector<std::string>& names);
std::vector<std::string> names_in_line(const Arrangement& arranged, std::size_t statement);

// The array of an output.
const Parameter& output_parameter(const Arrangement& arranged, std::size_t output);

// Whether a block or a fill stores it.
bool is_in_block(const Arrangement& arranged, std::size_t output, std::size_t element);

bool is_angle_function(symbolic::Op op);

// What supplies the sine or cosine of this argument: that of the whole value where the argument is a lane of it and all
// lanes are asked for.
AngleKey supplier(const Arrangement& arranged, const symbolic::Operand& argument);

}  // namespace robcogen::backend
