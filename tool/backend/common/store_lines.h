// The lines that store elements of outputs.
#pragma once

#include <string>
#include <vector>

#include "backend/common/kernel_lines.h"

namespace robcogen::backend {

class StoreLines {
 public:
  explicit StoreLines(KernelLines& lines) : lines_(lines) {}

  // Elements that have one value side by side: before all that stands between them.
  void add_fills();
  // Of a statement, all its lanes.
  void add_those_of(std::size_t statement);
  void add_block(const symbolic::Block& block);
  // Elements that are inputs or constants: each value once, in the order of the elements.
  void add_those_of_inputs();

 private:
  // An element of an output.
  struct Target {
    std::string text;
    std::size_t output = 0;
  };
  Target target_of(std::size_t output, std::size_t element) const;
  void store(const std::vector<Target>& targets, const symbolic::Operand& value);

  KernelLines& lines_;
};

}  // namespace robcogen::backend
