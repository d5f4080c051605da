// Functions for GPUs: the text of C in the macros of <robcogen/gpu/dialect.h>, which compiles as CUDA, HIP, OpenCL C,
// C99 and C++17, and a library that calls them for many states.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend::gpu {

// The files of a robot's library with these groups, as relative paths. They depend on the arguments alone. The prefix
// is the name of the library after its enclosing namespaces, `left_arm`.
std::vector<std::string> outputs(const std::string& prefix, const std::vector<std::string>& groups);

// Numbers of statements: functions that are longer than `longest` become stages of at most `stage`, not counting
// statements that are computed again. A thread of a GPU has 255 registers. Functions of several thousand statements
// keep what these do not hold in the first caches, and stages of a few hundred need few more.
struct Lengths {
  std::size_t longest = 8000;
  int stage = 300;
};

// Prints <prefix>_gpu/<group>.h with functions for kernels of users, <group>_kernels.h with kernels over many states,
// and <group>.cu with the functions of batch.h, which start them; model.h with the sizes of the robot, and
// <prefix>_gpu.h, which includes all functions. If the robot has parameters, functions take an array of values that
// depend on them, which <prefix>_gpu_update computes.
std::vector<OutputFile> print(const Library& library, const Lengths& lengths);
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::gpu
