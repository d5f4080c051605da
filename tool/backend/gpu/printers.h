// The printers behind `print`, one for each kind of file, and what they have in common.
#pragma once

#include <string>
#include <vector>

#include "backend/c/printers.h"

namespace robcogen::backend::gpu {

using c::Names;

// An array of a function over many states.
struct StatesArray {
  KernelArray array;
  std::size_t size = 0;  // elements of one state
  // Often the same for all states, so that kernels over tiles take it with any layout.
  bool is_often_same = false;
};

// A function of the library as one over many states.
struct StatesFunction {
  const c::NamedFunction* function = nullptr;  // null: the update of the cache
  std::string name;                            // `inverse_dynamics`; that of the device begins with the prefix
  std::vector<StatesArray> arrays;
};

std::vector<StatesFunction> states_functions(const Names& names, const std::string& group);

std::string print_model(const Names& names);
std::string print_functions(const Names& names, const std::string& group);
std::string print_kernels(const Names& names, const std::string& group);
// The declarations of all functions over many states in C and C++, and the unit that defines those of a group.
std::string print_batch(const Names& names, const std::vector<std::string>& groups);
std::string print_launches(const Names& names, const std::string& group);

}  // namespace robcogen::backend::gpu
