// The printers behind `print`, one for each kind of file, and what they have in common.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "backend/c/printers.h"
#include "backend/gpu/gpu.h"
#include "symbolic/stages.h"

namespace robcogen::backend::gpu {

// What the files of a library have in common: its names, and the functions that are too long for one kernel.
struct Names : c::Names {
  std::map<const Function*, symbolic::Stages> stages;
};

Names names(const Library& library, const Lengths& lengths = {});

// An array of a function over many states.
struct StatesArray {
  KernelArray array;
  std::size_t size = 0;               // elements of one state
  std::size_t rows = 0, columns = 0;  // of a matrix; otherwise, there are no columns
  // Often the same for all states, so that kernels over tiles take it with any layout.
  bool is_often_same = false;
};

// A kernel of a function over many states: the whole function, or one of its stages.
struct StatesKernel {
  std::string name;                 // begins with that of the function
  std::vector<std::size_t> arrays;  // into those of the function; the one behind the last is the workspace
  const symbolic::Stage* stage = nullptr;
  std::size_t number = 0;                             // of the stage
  const symbolic::Stage::Columns* columns = nullptr;  // if the stage replaces columns: which, in this kernel
  int lanes = 1;                                      // threads that share a state
};

// A function of the library as one over many states.
struct StatesFunction {
  const c::NamedFunction* function = nullptr;  // null: the update of the cache
  std::string name;                            // `inverse_dynamics`; that of the device begins with the prefix
  std::vector<StatesArray> arrays;
  const symbolic::Stages* stages = nullptr;  // null: the function is one kernel

  // In the order in which they run.
  std::vector<StatesKernel> kernels() const;
  // The kernel in which neighbouring threads share a state, for few states; nullopt: there is none.
  std::optional<StatesKernel> kernel_in_lanes() const;
  // One of the arrays, or the workspace, through which numbers pass from kernel to kernel.
  StatesArray array(std::size_t k) const;
};

std::vector<StatesFunction> states_functions(const Names& names, const std::string& group);
inline constexpr const char* kUpdateSummary = "Computes the values that functions read in place of the parameters.";

// The precisions of functions over many states: the type of numbers, the end of names, the stated rounding error.
struct Scalar {
  const char *type, *suffix;
  double symbolic::RoundingError::*error;
};
inline constexpr Scalar kScalars[] = {
    {"double", "", &symbolic::RoundingError::in_double},
    {"float", "f", &symbolic::RoundingError::in_float}};

std::string print_model(const Names& names);
std::string print_functions(const Names& names, const std::string& group);
std::string print_kernels(const Names& names, const std::string& group);
// The functions that the kernels of a function in stages call.
std::string print_stages(const Names& names, const StatesFunction& f);
std::string stage_name(const Names& names, const StatesFunction& f, std::size_t number);
// The functions of a group whose congruent limbs are computed by neighbouring threads.
std::string print_in_lanes(const Names& names, const std::string& group);
// Around text with lanes, which is C++ for GPUs.
std::string where_lanes_are(const std::string& text);
inline const std::string kInLanes = "in_lanes_";
// The declarations of all functions over many states in C and C++, and the unit that defines those of a group.
std::string print_batch(const Names& names, const std::vector<std::string>& groups);
std::string print_launches(const Names& names, const std::string& group);
// The Python package that calls them, and the program that checks and times them.
std::string print_python(const Names& names, const std::vector<std::string>& groups);
std::string print_bench(const Names& names, const std::vector<std::string>& groups);

}  // namespace robcogen::backend::gpu
