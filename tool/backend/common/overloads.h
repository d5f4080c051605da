// Overloads as one function whose last arguments may be left out, for languages that have no overloads.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend {

// The overloads of one function: each takes the arguments of the one before it and more. The printed text is that of
// the last overload; its additional arguments have defaults.
struct OverloadedFunction {
  std::string scope;
  std::string name;  // the name of the functions, until a language chooses another
  std::vector<const Function*> overloads;

  const Function& longest() const { return *overloads.back(); }
};

// In the order of the library. The result refers to the library.
std::vector<OverloadedFunction> overloaded_functions(const Library& library);

// `transforms`, `transforms.homogeneous`: each scope once, after the scopes that enclose it. The scopes of the
// functions must be dotted already.
std::vector<std::string> scopes(const std::vector<OverloadedFunction>& functions);

// How many of the arguments must be given. Gravity may be left out if it is the last argument and the base is fixed.
std::size_t required_inputs(const Library& library, const OverloadedFunction& overloaded);

// The lines that all overloads share, and the method of the first one. The loads that distinguish the overloads are
// described as arguments.
std::vector<std::string> summary(const OverloadedFunction& overloaded);

// `Takes 32 multiplications, …`
std::string describe_operations(const Library& library, const Function& function);

}  // namespace robcogen::backend
