// The last step of lowering: splits long kernels into functions that are called one after the other. Compile time grows
// faster than the length of a function, and long functions keep fewer values in registers.
#pragma once

#include <cstddef>
#include <vector>

#include "backend/common/lower.h"

namespace robcogen::backend {

// Compilers take less than half as long for parts of hundreds of lines as for thousands at once.
inline constexpr KernelLengths kLengths =
    {.longest = 2000, .longest_in_lanes = 2000, .cached = static_cast<std::size_t>(-1), .part = 700, .short_part = 700};

// The same without cost in run time. Code that exceeds the instruction cache (64 KB, 21 bytes a line on x86-64) takes
// time that grows with its size, and a processor keeps few values with lanes in registers: there, short parts are
// faster.
inline constexpr KernelLengths kLengthsOfTemplates =
    {.longest = 2000, .longest_in_lanes = 1000, .cached = 3000, .part = 700, .short_part = 200};

// An array of values of one width that are live between parts.
struct LiveValues {
  KernelArray array;
  std::size_t size = 0;
};

struct SplitKernel {
  std::vector<Kernel> parts;     // in call order; parameters: those that the part uses, then arrays of `live`
  std::vector<LiveValues> live;  // by ascending width
};

// Whether the kernel is to be split.
bool is_long(const Kernel& kernel, const Dialect& dialect);

// Cuts the kernel between sections into parts of the length that the dialect asks for.
SplitKernel split_kernel(const Kernel& kernel, const Dialect& dialect);

// Cuts the kernel between sections into parts of at most `longest` lines each (a longer section stays whole), so that
// few values are live between them. A value is kept in an array from the part that computes it to the last part that
// reads it; each reader gives it its original name. Elements and blocks of inputs that have names are named in each
// part that reads them.
SplitKernel split_kernel(const Kernel& kernel, std::size_t longest, const Dialect& dialect);

}  // namespace robcogen::backend
