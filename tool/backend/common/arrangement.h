// The lines of a lowered function before they are written: which statements are lines of their own, where their values
// go, and how each is spelled.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "backend/common/line_plan.h"
#include "backend/common/lower.h"

namespace robcogen::backend {

struct Arrangement : LinePlan {
  const symbolic::Program& program;
  const Dialect& dialect;
  NameScope scope;
  std::vector<Parameter> parameters = {};
  std::vector<Line> bindings = {};              // by Dialect::binds_parameters
  std::vector<std::string> input_names = {};    // by flat index: `q[1]`
  std::vector<std::string> input_sources = {};  // by flat index: what this text refers to: the array, or a binding
  Texts texts = {};                             // of spellings; those of names are where these are
  std::vector<Spelling> constants = {};
  // By statement.
  std::vector<std::string> names = {};
  std::vector<Spelling> spellings = {};    // how a user reads the statement, unless it stands inside
  std::vector<Spelling> expressions = {};  // what it is: stands in its line, or inside its user
  // Of the blocks that are loaded.
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

// The array of an output, and an element of it.
const Parameter& output_parameter(const Arrangement& arranged, std::size_t output);
std::string target(const Arrangement& arranged, std::size_t output, std::size_t element);

// What supplies the sine or cosine of this argument: that of the whole value where the argument is a lane of it and all
// lanes are asked for.
AngleKey supplier(const Arrangement& arranged, const symbolic::Operand& argument);

}  // namespace robcogen::backend
