// The printers behind `print`: each makes the text of one kind of file.
#pragma once

#include <string>
#include <vector>

#include "backend/c/c.h"
#include "backend/c/dialect.h"

namespace robcogen::backend::c {

// A function under its names in C, by precision.
struct Callable {
  const Function* function = nullptr;
  std::string name, name_in_float;
  bool reads_cache = false;  // what it reads of the parameters was computed before

  const std::string& name_in(const Precision& precision) const { return precision.is_float ? name_in_float : name; }
};

// What the files of a library have in common.
struct Names {
  const Library& library;
  std::string prefix;                // `hyl`
  std::string folder;                // `hyl_c`
  std::vector<Callable> callables;   // in the order of Library::functions, then Library::updates
  std::vector<std::string> members;  // of the structure of parameters, by parameter
};

Names names(const Library& library);

// The comment at the top of a file.
std::string opening(const Names& names, const std::string& file, const std::string& what);
// The same of a header, with its guard, what it declares and, where there are functions or constants, that it is C.
std::string header(const Names& names, const std::string& file, const std::string& what, const std::string& body);

std::string print_model_header(const Names& names);
std::string print_model(const Names& names);
std::string print_header(const Names& names, const std::string& group);
std::string print_functions(const Names& names, const std::string& group, const Precision& precision);

}  // namespace robcogen::backend::c
