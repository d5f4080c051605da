// From a program to the lines of a C++ kernel: what is a statement of its own, what stands inside its user, every name.
//
// What is left to the printer is layout. Lines are short enough (120 columns) never to wrap.
#pragma once

#include <string>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::backend::cpp {

// `const Scalar* name`, or `Scalar* name` for an output.
struct Parameter {
  std::string name;
  bool output = false;
  bool used = true;  // an unused parameter gets no name
};

struct Line {
  enum class Kind {
    section,     // a comment: `expression` is its text
    sincos,      // targets: sine and cosine of `expression`
    definition,  // targets: the one name that is defined
    store,       // targets: elements of outputs that get the same value
  };
  Kind kind = Kind::definition;
  std::vector<std::string> targets;
  std::string expression;
};

struct Kernel {
  std::string name;
  std::vector<Parameter> parameters;
  std::vector<std::string> functions;  // of `std`, found by argument-dependent lookup for other scalars: cos, sin, sqrt
  std::vector<Line> lines;
};

// Inputs, then outputs, under the names that they have in the kernel; all marked as used.
std::vector<Parameter> parameters(const symbolic::Program& program);

// The rules:
// - Sines and cosines of plain inputs come first, one pair an argument; a lone sine or cosine is a definition.
// - A statement that is used once and that the algorithm did not name stands inside its user, as far as the line has
//   room: products inside sums first of all, for a compiler fuses them only within one expression. Evaluation order is
//   that of the program.
// - A value that only outputs use is stored without a name, equal elements at once.
// - Statements that no output needs are left out.
Kernel lower(const symbolic::Program& program, const std::string& name);

// The line without indentation, ready to be printed.
std::string text(const Line& line);

}  // namespace robcogen::backend::cpp
