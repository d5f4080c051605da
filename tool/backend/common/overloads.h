// Overloads as one function whose last arguments may be left out, for languages that have no overloads.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend {

// Overloads of one function: each takes the arguments of the one before it and more. The text is that of the last one,
// whose additional arguments have defaults.
struct Callable {
  std::string scope;
  std::string name;  // that of the functions, until a language chooses another
  std::vector<const Function*> overloads;

  const Function& longest() const { return *overloads.back(); }
};

// In the order of the library, which they refer to.
std::vector<Callable> callables(const Library& library);

// `transforms`, `transforms.homogeneous`: each scope once, those that enclose it before it. The callables have dotted
// ones.
std::vector<std::string> scopes(const std::vector<Callable>& callables);

// How many of the arguments must be given. Gravity, when it is the last of them, need not, unless the base floats.
std::size_t required_inputs(const Library& library, const Callable& callable);

// What all overloads say, and how the first is computed: the loads that distinguish them are described as arguments.
std::vector<std::string> summary(const Callable& callable);

// `Takes 32 multiplications, …`
std::string describe_operations(const Library& library, const Function& function);

}  // namespace robcogen::backend
