// C99 and the macros of GPUs as dialects, the names of a library, and the printers behind `print`, one for each kind of
// file.
#pragma once

#include <string>
#include <vector>

#include "backend/c/c.h"
#include "backend/common/c_text.h"
#include "backend/common/lower.h"

namespace robcogen::backend::c {

using c_family::banner;
using c_family::braced;
using c_family::comment;
using c_family::kColumns;
using c_family::quoted;

struct Precision {
  std::string scalar;    // the type
  std::string suffix;    // suffix of function names, in <math.h> and in the library
  std::string file_end;  // end of a source file's name
  bool is_float = false;
  // Text for GPUs: arrays, numbers and functions are macros of <robcogen/gpu/dialect.h>.
  bool is_macro = false;
};

inline const Precision kDouble = {"double", "", ".c"}, kFloat = {"float", "f", "_f.c", true};
inline const Precision kMacros = {"REAL", "", ".h", false, true};
inline const std::vector<Precision> kPrecisions = {kDouble, kFloat};

// Where functions read a cache, parameters are elements of its array; otherwise they are members of a structure.
Dialect dialect(const Precision& precision, bool reads_cache);

// The macros of GPUs for programs with lanes, in C++.
Dialect dialect_with_lanes();

// A literal of any value. In single precision it is the nearest one, infinite beyond the largest.
std::string number(double value, const Precision& precision);

// `head(items)tail`, on several lines if one would be too long.
std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail);

// A function with its names in C, one per precision.
struct NamedFunction {
  const Function* function = nullptr;
  std::string name, name_in_float;
  bool reads_cache = false;  // it takes the cache, computed beforehand from the parameters

  const std::string& name_in(const Precision& precision) const { return precision.is_float ? name_in_float : name; }
};

// What the files of a library have in common.
struct Names {
  const Library& library;
  std::string prefix;                    // `hyl`
  std::string folder;                    // `hyl_c`
  std::vector<NamedFunction> functions;  // in the order of Library::functions, then Library::updates

  // Replaces @ by the prefix, % by the scalar type, and $ by the suffix of names.
  std::string in(const Precision& precision, std::string text) const;
};

Names names(const Library& library);
// The same with other names, whose functions begin with `prefix`.
Names names(const Library& library, const std::string& prefix, const std::string& folder);

// What a function computes, and its arrays, as a comment.
std::string documentation(const Names& names, const NamedFunction& c, const std::vector<KernelArray>& list);
// The array as a call passes it on.
std::string passed(const KernelArray& array, const Precision& precision);
// `RC_FUNCTION(2) f(RC_IN(1, q), RC_OUT(2, H))`, or a part of it: of text for GPUs.
std::string macro_signature(const std::string& name, const std::vector<KernelArray>& list, const std::string& end);
// Arrays that functions keep to themselves: plain ones in text for GPUs too.
bool is_kept(const std::string& array);

// A header: its guard around `body`.
std::string header(const Names& names, const std::string& file, const std::string& what, const std::string& body);

// The reference of the header to the library's model, and its definition in the source of a group, if that has it.
std::string identity_reference(const Names& names);
std::string identity_definition(const Names& names, const std::string& group);

// `enum { hyl_dof = 3, … };`
std::string enumeration(const Names& names);

std::string print_model_header(const Names& names);
std::string print_model(const Names& names);
std::string print_header(const Names& names, const std::string& group);
// The functions of a group one after the other; in text for GPUs, with their documentation.
std::string print_bodies(const Names& names, const std::string& group, const Precision& precision);
std::string print_functions(const Names& names, const std::string& group, const Precision& precision);

}  // namespace robcogen::backend::c
