// What the functions over many states of a library have in common: the functions that it compiles, and their arrays.
#pragma once

#include <string>
#include <vector>

#include "backend/cpp/api.h"

namespace robcogen::backend::cpp {

// An array of a function, of one state. Parameters are the same for all states.
struct BatchArray {
  std::string name;
  std::string type;  // of one state
  int size = 0;
  int rows = 0;
  bool is_output = false;
  bool is_parameters = false;
  bool is_gravity = false;
};

// Inputs, then outputs, as the kernel has them.
std::vector<BatchArray> batch_arrays(const symbolic::Program& program);

// Whether the result of a function is one symmetric matrix, of which the lower triangle is available alone.
bool is_symmetric(const Callable& callable);

// Whether the results of a block of states would outgrow the stacks of threads: states are taken one by one then.
bool takes_single_states(const Callable& callable);

// A function that is compiled: of a symmetric matrix there is a second one, that writes the lower triangle alone.
struct BatchKernel {
  const Callable* callable = nullptr;
  bool is_lower = false;

  std::string name() const { return callable->kernel + (is_lower ? "_lower" : ""); }
};

std::vector<BatchKernel> batch_kernels(const std::vector<const Callable*>& callables);
std::vector<BatchKernel> batch_kernels(const Api& api);

// Parameters, the number of states, then the others; `with_names` or types alone.
std::vector<std::string> batch_parameters(const BatchKernel& kernel, const std::string& scalar, bool with_names);

// Explicit instantiations for all scalars; `extra` ends the list of types.
std::string batch_instantiations(
    const Api& api,
    const BatchKernel& kernel,
    const std::string& arguments,
    const std::vector<std::string>& extra = {});

// `template <Level, class Scalar> void f(…) noexcept`, without its end.
std::string batch_body_declaration(const BatchKernel& kernel, const std::string& tail);

}  // namespace robcogen::backend::cpp
