// A long function as stages that run one after the other, such as kernels of a GPU.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Values that a later stage reads pass through this array.
inline constexpr const char* kWorkspace = "workspace";
// Neighbouring columns of an output that a stage replaces by others.
inline constexpr const char* kColumns = "columns";

// Stages read and write these arrays: an output of this name and an input of this name are one array.
inline bool is_read_and_written(std::string_view array) {
  return array == kWorkspace || array == kColumns;
}

// In place of an output's element: the stage does not write it.
inline constexpr Operand kNotWritten = {Operand::Kind::statement, -1};

struct Stage {
  // Inputs: those of the function, then the workspace; or the workspace and columns. Outputs: those of which the stage
  // writes elements, and the same arrays.
  Program program;

  // Of a stage that replaces columns: it runs `runs` times, for neighbouring groups of columns of an output.
  struct Columns {
    int output = 0;
    int first = 0;   // element at which the first group begins
    int stride = 0;  // elements of a group
    int runs = 0;
  };
  std::vector<Columns> columns = {};  // one after another; empty: the stage runs once
};

struct Stages {
  std::vector<Stage> list;
  int workspace = 0;  // elements
};

// The arrays of a function that one of its stages reads or writes, ascending: inputs, then outputs, then the workspace.
// Not for stages that replace columns. `function`: its inputs and outputs suffice.
std::vector<std::size_t> arrays_of(const Stage& stage, const Program& function);

}  // namespace robcogen::symbolic
