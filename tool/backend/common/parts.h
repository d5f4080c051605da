// Splits long kernels into functions that are called one after the other: the time of compilers grows faster than the
// length of a function, and long functions keep fewer values in registers.
#pragma once

#include <cstddef>
#include <vector>

#include "backend/common/lower.h"

namespace robcogen::backend {

// Kernels of more lines than these are split, into parts of about so many: compilers take less than half as long for
// parts of hundreds of lines as for thousands at once.
inline constexpr std::size_t kLongest = 2000, kPart = 700;

// An array of values of one width that parts pass on.
struct Handed {
  Parameter array;
  std::size_t size = 0;
};

struct Parts {
  std::vector<Kernel> kernels;  // in order of the calls; parameters: those that are used, then arrays of `handed`
  std::vector<Handed> handed;   // by ascending width
};

// Cuts the kernel between sections into parts of at most so many lines each (a longer section stays whole), so that few
// values are handed on. Each value stands in an array from the part that computes it to the last that reads it, which
// names it as it was named; elements and blocks of inputs that have names are named in each part that reads them.
Parts in_parts(const Kernel& kernel, std::size_t longest, const Dialect& dialect);

}  // namespace robcogen::backend
