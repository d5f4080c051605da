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
  std::vector<KernelArray> parameters = {};
  std::vector<Line> bindings = {};              // if Dialect::binds_parameters
  std::vector<std::string> input_names = {};    // by flat index: `q[1]`
  std::vector<std::string> input_sources = {};  // by flat index: the array or the binding that this text refers to
  Texts texts = {};                             // the texts of spellings that are not names
  std::vector<Spelling> constants = {};
  // Indexed by statement.
  std::vector<std::string> names = {};
  std::vector<Spelling> spellings = {};    // as its users read the statement, unless it stands inside its user
  std::vector<Spelling> expressions = {};  // the expression, in a line of its own or inside its user
  // Indexed by load of the block plan.
  std::vector<std::string> load_names = {};
};

Arrangement arrange(const symbolic::Program& program, const Dialect& dialect);

// The square whose root a statement is, where the language has a function for magnitudes; null for other statements.
const symbolic::Statement* square_of_magnitude(const Arrangement& arranged, std::size_t statement);

// The expression of a statement whose operands are already spelled.
Spelling expression(Arrangement& arranged, std::size_t statement);

// An operand as the function reads it, or as an operand of a statement with this many lanes.
Spelling spell(Arrangement& arranged, const symbolic::Operand& o);
Spelling spell(Arrangement& arranged, const symbolic::Operand& o, int lanes);
Spelling lane_of(Arrangement& arranged, Spelling value, int lane);

// The line of a statement. For a statement that stands inside another, this is the line that it would have by itself.
Line line(const Arrangement& arranged, std::size_t statement);

// The names (Line::names) that the text of an operand with this many lanes, or the line of a statement, refers to.
void add_names(const Arrangement& arranged, const symbolic::Operand& o, int lanes, std::vector<std::string>& names);
std::vector<std::string> names_in_line(const Arrangement& arranged, std::size_t statement);

// The array of an output, and one of its elements.
const KernelArray& output_parameter(const Arrangement& arranged, std::size_t output);
std::string target(const Arrangement& arranged, std::size_t output, std::size_t element);

// The angle that supplies the sine or cosine of this argument. This is the whole value if the argument is a lane of it
// and the sines and cosines of all lanes are computed.
AngleKey supplier(const Arrangement& arranged, const symbolic::Operand& argument);

}  // namespace robcogen::backend
