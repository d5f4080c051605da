// Functions over many states: the functions that a library compiles, and their arrays.
#pragma once

#include <string>
#include <vector>

#include "backend/cpp/api.h"

namespace robcogen::backend::cpp {

// An array of a function, for one state. Parameters are the same for all states.
struct BatchArray {
  std::string name;
  std::string type;  // of one state
  int size = 0;
  int rows = 0;
  bool is_output = false;
  bool is_parameters = false;
  bool is_gravity = false;
};

// Inputs, then outputs, in the order of the kernel.
std::vector<BatchArray> batch_arrays(const symbolic::Program& program);

// Whether the result of a function is a single symmetric matrix, whose lower triangle is also available alone.
bool is_symmetric(const Callable& callable);

// A function that is compiled. If the result is a symmetric matrix, a second one writes the lower triangle alone.
struct BatchKernel {
  const Callable* callable = nullptr;
  bool is_lower = false;

  std::string name() const { return callable->kernel + (is_lower ? "_lower" : ""); }
};

std::vector<BatchKernel> batch_kernels(const std::vector<const Callable*>& callables);
std::vector<BatchKernel> batch_kernels(const Api& api);

// The parameters, the number of states, then all other arguments, with their names or as types alone.
std::vector<std::string> batch_parameters(const BatchKernel& kernel, const std::string& scalar, bool with_names);

// Explicit instantiations for all scalars; `extra` follows the other types.
std::string batch_instantiations(
    const Api& api,
    const BatchKernel& kernel,
    const std::string& arguments,
    const std::vector<std::string>& extra = {});

// `template <Level, class Scalar> void f(…) noexcept`, without its end.
std::string batch_body_declaration(const BatchKernel& kernel, const std::string& tail);

}  // namespace robcogen::backend::cpp
