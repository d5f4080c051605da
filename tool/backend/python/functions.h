// Functions as Python has them: one for all overloads, with the shapes of arrays and documentation.
#pragma once

#include <string>
#include <vector>

#include "backend/cpp/api.h"

namespace robcogen::backend::python {

// The same data as robcogen::python::Argument of the runtime.
struct Array {
  std::string name;
  int rank = 1;
  int rows = 1, columns = 1, pages = 1;
  bool is_by_rows = false;
  bool is_parameters = false;
  std::vector<int> quaternions = {};       // the elements that begin unit quaternions
  std::string meaning = {};                // what the documentation says of it
  std::vector<std::string> elements = {};  // their names, where the documentation lists them
};

struct Function {
  std::string scope;  // `transforms.homogeneous`
  std::string name;
  std::vector<const cpp::Callable*> overloads;  // fewest inputs first; each has the inputs of the one before it
  std::vector<Array> arguments = {}, results = {};
  int required = 0;
  std::vector<std::string> summary = {};
  std::string remark = {};
  std::string call = {};  // a function of the runtime that computes it, if it has no overloads
};

// The functions of the library, then those of poses of the base.
std::vector<Function> functions(const cpp::Api& api);

// Functions for poses of the base: conversions, gravity, integration. They are printed for robots with a floating base,
// and partly for robots that stand somewhere in the world.
std::vector<Function> pose_functions(const cpp::Api& api);

// The signature as Python's `help` and `inspect` read it, a description, and the shapes.
std::vector<std::string> documentation_of(const Function& function);

// The text of the stub.
std::string print_stub(const Library& library, const std::vector<Function>& functions);

}  // namespace robcogen::backend::python
