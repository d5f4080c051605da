// Lowering: from a program to the lines of a function in some language. It decides which statements get lines of their
// own, which stand inside their users, and every name.
//
// Only layout is left to a printer. Lines are short enough that they never wrap.
#pragma once

#include <string>
#include <vector>

#include "backend/common/names.h"
#include "backend/common/spelling.h"
#include "symbolic/program.h"

namespace robcogen::backend {

// An argument or a result, as an array.
struct KernelArray {
  std::string name;
  bool output = false;
  bool used = true;                        // an unused parameter needs no name
  std::vector<std::string> elements = {};  // if Dialect::names_variables: arguments of their own
  int width = 1;                           // lanes of each element
  bool is_structure = false;               // the parameters, passed as a structure
};

struct Line {
  enum class Kind {
    section,      // a comment: `expression` is its text
    binding,      // targets: the name of `expression`, an element of an array
    sincos,       // targets: sine and cosine of `expression`
    sincos_of,    // targets: the name for the sines and cosines of `count` elements, from `expression` on
    pick,         // targets: the two values of `expression`: a sine and cosine of `sincos_of`, or two sums of lanes
    definition,   // targets: the one name that is defined
    store,        // targets: elements of outputs that get the same value
    load_block,   // targets: the name of `count` values, whose first element is `expression`
    store_block,  // targets: the first output element that receives the lanes of `values`
    fill,         // targets: the first of `count` elements of an output that get the value
    arc_tangents  // targets: the first of some elements of an output; values: sine and cosine of each angle, in turn
  };
  Kind kind = Kind::definition;
  std::vector<std::string> targets;
  std::string expression;
  std::size_t count = 0;                 // of sincos_of, load_block and fill
  int width = 1;                         // lanes of the defined value
  int stride = 0;                        // of blocks: distance from lane to lane
  std::vector<std::string> values = {};  // also of a store: the sine and the cosine of its angle
  std::size_t output = 0, element = 0;   // of such a store: where the angle goes
  bool is_small = false;                 // of sincos: the angle is known to be small
  bool is_reference = false;             // of sincos: the angle is an element of reference positions
  // The names that the text refers to: values of other lines, parameters, functions and types.
  std::vector<std::string> names = {};
};

struct Kernel {
  std::string name;
  std::vector<KernelArray> parameters;
  std::vector<std::string> functions;  // that the lines call, except through Dialect::pairs_angles
  std::vector<int> widths;             // of values with lanes, ascending
  std::vector<Line> lines;
  std::vector<std::vector<std::string>> results;  // by output: its elements, where Dialect::stores is off
};

// Numbers of lines that decide which kernels are split, and into how long parts (split_kernel.h).
struct KernelLengths {
  std::size_t longest, longest_in_lanes;  // of kernels that stay whole
  std::size_t cached;                     // of kernels that fit in the instruction cache
  std::size_t part, short_part;           // short: of kernels with lanes, and of those that exceed the cache
};

// How a language spells what lowering decides.
struct Dialect {
  IsReserved is_reserved = nullptr;
  std::vector<std::string> used_names;  // names that the text itself refers to
  std::size_t line_limit = 118;         // of a line without indentation
  std::size_t indentation = 2;          // of lines; a continuation line contains it in its text
  std::size_t around = 24;  // upper bound on what a definition's line contains besides its name and its expression
  std::size_t name_limit = 30;
  // One line defines both the sine and the cosine of an argument. Otherwise these are two definitions.
  bool pairs_angles = true;
  // The names of the functions in the language.
  std::string sine = "sin", cosine = "cos", square_root = "sqrt", arc_tangent = "atan2";
  // The name of a function for magnitudes, sqrt(x * x); empty: spelled as it is.
  std::string magnitude = "";
  // The name of a function for quotients; empty: the operator.
  std::string quotient = "";
  // If at least this many elements of one input have sines and cosines, these are computed together; 0: never. The
  // sines and cosines of elements in between are computed too.
  std::size_t angles_together = 0;
  // If at least this many arc tangents are stored in neighbouring elements of an output, they are computed together; 0:
  // never.
  std::size_t arc_tangents_together = 0;
  KernelLengths lengths{};  // for languages that split long kernels
  // Elements of outputs are stored as they are computed, and `results` stays empty. Otherwise each element is a name,
  // an input element or a number, and the printer puts the outputs together at the end.
  bool stores = true;
  // Parameters and given sines and cosines that are read get names from their labels, one line each, before all else.
  bool binds_parameters = false;
  // The variables of a document are separate arguments, named by their labels.
  bool names_variables = false;
  // The literal of a number that is not negative.
  Spelling (*literal)(const Number& value, Texts& texts) = nullptr;
  // For values with lanes: the name of their type.
  std::string (*type)(int width) = nullptr;
  // Element k of an array; k counts from 0.
  std::string (*element)(const std::string& array, std::size_t k) = nullptr;
  // Where parameters are passed as a structure: its members, from the labels of all parameters, and the text in front
  // of a member's name.
  std::vector<std::string> (*members)(const std::vector<std::string>& labels) = nullptr;
  std::string member_access = ".";
  // Where parameters are passed as an array in a structure: the array's name, with the text in front of it.
  std::string member_array = "";
  // A line is `definition target assignment expression end`: `const double x = y;`. A store has no `definition`.
  std::string definition = "", assignment = " = ", end = ";";
  // For languages with other lines: the line, ready to be printed.
  std::string (*text)(const Line& line) = nullptr;
  // For `body`: the comment that heads a section, as lines indented by two.
  std::string (*section)(const std::string& text) = nullptr;
};

// The line in the language, without indentation.
std::string text(const Line& line, const Dialect& dialect);

// The dialect of languages whose functions return their results: the sine and the cosine of an argument are two
// definitions, and the printer puts the outputs together at the end. `columns` is the longest line, with its
// indentation.
Dialect returning_dialect(std::size_t columns);

// Inputs, then outputs, under the names that they have in the function; all marked as used. Variables take their names
// before arrays do.
std::vector<KernelArray> parameters(const symbolic::Program& program, const Dialect& dialect);

// The names as a call lists them.
std::vector<std::string> names_of(const std::vector<KernelArray>& parameters);

// The lines of the function, indented by two, after the text `before`, with an empty line in front of each section.
std::string body(const Kernel& kernel, const Dialect& dialect, std::string before = "");

// The rules:
// - Parameters, sines and cosines that are read come first, where Dialect::binds_parameters is on.
// - Sines and cosines of plain inputs come first, one pair per argument; a lone sine or cosine is a definition.
// - A statement that is used once and that the algorithm did not name stands inside its user, as far as the line has
//   room. Products inside sums take precedence, because a compiler fuses them only within one expression. The
//   evaluation order is that of the program.
// - A value with lanes gets a name if one of its lanes is read. A scalar that all lanes take gets one too, and is
//   spread where it is used.
// - A value that only outputs use is stored without a name; equal elements are stored at once.
// - Two consecutive sums of lanes share one line, whatever their users are.
// - In programs with lanes, neighbouring elements of an array are loaded and stored in blocks (symbolic/blocks.h).
// - Statements that no output needs are left out.
Kernel lower(const symbolic::Program& program, const std::string& name, const Dialect& dialect);

}  // namespace robcogen::backend
