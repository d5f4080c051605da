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
  int rows = 1, columns = 1;
  bool is_by_rows = false;
  bool is_parameters = false;
  std::vector<std::string> elements = {};  // their names, where the documentation lists them
};

struct Function {
  std::string scope;  // `transforms.homogeneous`
  std::string name;
  std::vector<const cpp::Callable*> overloads;  // fewest inputs first; each has the inputs of the one before it
  std::vector<Array> arguments, results;
  int required = 0;

  const backend::Function& longest() const { return *overloads.back()->function; }
};

std::vector<Function> functions(const cpp::Api& api);

// The signature as Python's `help` and `inspect` read it, a description, and the shapes.
std::vector<std::string> documentation_of(const Function& function);

// The text of the stub.
std::string print_stub(const Library& library, const std::vector<Function>& functions);

}  // namespace robcogen::backend::python
