// From a program to the lines of a function in some language: what is a statement of its own, what stands inside its
// user, every name.
//
// What is left to a printer is layout. Lines are short enough never to wrap.
#pragma once

#include <string>
#include <vector>

#include "backend/common/names.h"
#include "backend/common/spelling.h"
#include "symbolic/program.h"

namespace robcogen::backend {

// An argument or a result, as an array.
struct Parameter {
  std::string name;
  bool output = false;
  bool used = true;                        // an unused parameter needs no name
  std::vector<std::string> elements = {};  // by Dialect::names_variables: arguments of their own
  int width = 1;                           // of its elements: lanes
  bool is_structure = false;               // parameters
};

struct Line {
  enum class Kind {
    section,      // a comment: `expression` is its text
    binding,      // targets: the name of `expression`, an element of an array
    sincos,       // targets: sine and cosine of `expression`
    sincos_of,    // targets: the name that stands for sines and cosines of `count` elements, from `expression` on
    pick,         // targets: the two values of `expression`: sine and cosine of one of them, or sums of lanes
    definition,   // targets: the one name that is defined
    store,        // targets: elements of outputs that get the same value
    load_block,   // targets: the name of `count` values, whose first element is `expression`
    store_block,  // targets: the first element of what takes the lanes of `values`
    fill,         // targets: the first of `count` elements of an output that get the value
  };
  Kind kind = Kind::definition;
  std::vector<std::string> targets;
  std::string expression;
  std::size_t count = 0;  // of sincos_of, load_block and fill
  int width = 1;          // of what is defined: lanes
  int stride = 0;         // of blocks: from lane to lane
  std::vector<std::string> values = {};
  bool is_small = false;  // of sincos: the angle is known to be small
  // What the text refers to: values of other lines, parameters, functions and types, each by its name.
  std::vector<std::string> names = {};
};

struct Kernel {
  std::string name;
  std::vector<Parameter> parameters;
  std::vector<std::string> functions;  // that the lines call, but for Dialect::pairs_angles
  std::vector<int> widths;             // of values with lanes, ascending
  std::vector<Line> lines;
  std::vector<std::vector<std::string>> results;  // by output: its elements, where Dialect::stores is off
};

// How a language spells what lowering decides.
struct Dialect {
  IsReserved is_reserved = nullptr;
  std::vector<std::string> used_names;  // that the text itself refers to
  std::size_t line_limit = 118;         // of a line without indentation
  std::size_t indentation = 2;          // of lines, which those that continue one have in their text
  std::size_t around = 24;  // at most, in the line of a definition: all but its name and the text of its expression
  std::size_t name_limit = 30;
  // One line defines the sine and the cosine of an argument. Otherwise these are two definitions.
  bool pairs_angles = true;
  // The functions, by the names that they have in the language.
  std::string sine = "sin", cosine = "cos", square_root = "sqrt", arc_tangent = "atan2";
  // Where that many elements of one input have sines and cosines, these are computed together; 0: never. Elements
  // between them are computed too.
  std::size_t angles_together = 0;
  // Elements of outputs are stored as they are computed, and `results` stays empty. Otherwise each is a name, an
  // element of an input or a number, and the printer puts the outputs together at the end.
  bool stores = true;
  // Parameters, and given sines and cosines, that are read are named by their labels, a line each, before all else.
  bool binds_parameters = false;
  // Variables of a document come as arguments of their own, by their labels.
  bool names_variables = false;
  // A number that is not negative.
  Spelling (*literal)(const Number& value, Texts& texts) = nullptr;
  // Where values have lanes: the name of their type.
  std::string (*type)(int width) = nullptr;
  // Element k, from 0, of an array.
  std::string (*element)(const std::string& array, std::size_t k) = nullptr;
  // Where parameters come as a structure: its members, by the labels of all parameters, and what stands before them.
  std::vector<std::string> (*members)(const std::vector<std::string>& labels) = nullptr;
  std::string member_access = ".";
  // Where they come as an array in a structure: its name, with what stands before it.
  std::string member_array = "";
  // A line is `definition target assignment expression end`: `const double x = y;`. A store has no `definition`.
  std::string definition = "", assignment = " = ", end = ";";
  // Of a language with other lines: the line, ready to be printed.
  std::string (*text)(const Line& line) = nullptr;
  // For `body`, the comment that heads a section, as lines that are indented by two.
  std::string (*section)(const std::string& text) = nullptr;
};

// The line in the language, without indentation.
std::string text(const Line& line, const Dialect& dialect);

// Of a language whose functions return their results: the sine and the cosine of an argument are two definitions, and
// the printer puts the outputs together at the end. `columns` is what a line may have with its indentation.
Dialect returning_dialect(std::size_t columns);

// Inputs, then outputs, under the names that they have in the function; all marked as used. Variables keep their names
// before arrays do.
std::vector<Parameter> parameters(const symbolic::Program& program, const Dialect& dialect);

// As a call lists them.
std::vector<std::string> names_of(const std::vector<Parameter>& parameters);

// The lines of the function, indented by two, behind other text, with an empty line in front of each section.
std::string body(const Kernel& kernel, const Dialect& dialect, std::string before = "");

// The rules:
// - Parameters, sines and cosines that are read come first, where Dialect::binds_parameters is on.
// - Sines and cosines of plain inputs come first, one pair an argument; a lone sine or cosine is a definition.
// - A statement that is used once and that the algorithm did not name stands inside its user, as far as the line has
//   room: products inside sums first of all, for a compiler fuses them only within one expression. Evaluation order is
//   that of the program.
// - Values of several lanes are names of their own where a lane is read; scalars that all lanes take are spread there.
// - A value that only outputs use is stored without a name, equal elements at once.
// - Two sums of lanes that follow each other are one line, whichever users they have.
// - Of programs with lanes, what stands side by side in an array is loaded and stored in blocks (symbolic/blocks.h).
// - Statements that no output needs are left out.
Kernel lower(const symbolic::Program& program, const std::string& name, const Dialect& dialect);

}  // namespace robcogen::backend
