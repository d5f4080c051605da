// Splits long kernels into functions that are called one after the other: compile time grows faster than the length of
// a function, and long functions keep fewer values in registers.
#pragma once

#include <cstddef>
#include <vector>

#include "backend/common/lower.h"

namespace robcogen::backend {

// Kernels of more than kLongest lines are split into parts of about kPart lines: compilers take less than half as long
// for parts of hundreds of lines as for thousands at once.
inline constexpr std::size_t kLongest = 2000, kPart = 700;

// An array of values of one width that parts pass on.
struct Handed {
  Parameter array;
  std::size_t size = 0;
};

struct Parts {
  std::vector<Kernel> kernels;  // in call order; parameters: those that the part uses, then arrays of `handed`
  std::vector<Handed> handed;   // by ascending width
};

// Cuts the kernel between sections into parts of at most `longest` lines each (a longer section stays whole), so that
// few values are handed on. A value is kept in an array from the part that computes it to the last part that reads it;
// each reader gives it its original name. Elements and blocks of inputs that have names are named in each part that
// reads them.
Parts in_parts(const Kernel& kernel, std::size_t longest, const Dialect& dialect);

}  // namespace robcogen::backend
