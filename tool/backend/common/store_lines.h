// The lines that store elements of outputs.
#pragma once

#include <string>
#include <vector>

#include "backend/common/kernel_lines.h"

namespace robcogen::backend {

class StoreLines {
 public:
  explicit StoreLines(KernelLines& lines) : lines_(lines) {}

  // Fills ranges of elements that share one value. This comes first, because elements in between are overwritten later.
  void add_fills();
  // Stores the elements that a statement supplies, for all of its lanes.
  void add_those_of(std::size_t statement);
  void add_block(const symbolic::Block& block);
  // Stores the elements that are inputs or constants: each value once, in the order of the elements.
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
