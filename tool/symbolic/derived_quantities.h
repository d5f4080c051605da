// The quantities of a program's values: those that the algorithm gave, and those that follow from the operands.
#pragma once

#include <string>
#include <vector>

#include "support/index.h"
#include "symbolic/program.h"
#include "symbolic/quantity.h"

namespace robcogen::symbolic {

// Longer names make lines that are hard to read.
inline constexpr std::size_t kLongestQuantityName = 28;

// The quantity of a value, and whether the value is its negative.
struct Signed {
  QuantityRef quantity;  // null if nothing is known about the value
  bool negative = false;
};

std::string text(const Signed& value);

class Quantities {
 public:
  explicit Quantities(const Program& program);

  const Program& program() const { return program_; }
  std::size_t size() const { return statements_.size(); }
  const Signed& operator[](std::size_t statement) const { return statements_[statement]; }
  Signed of(const Operand& o) const;

  const Statement* statement(const Operand& o) const {
    return is_statement(o) ? &program_.statements[at(o.index)] : nullptr;
  }
  bool is_number(const Operand& o, double value) const {
    return is_constant(o) && program_.constants[at(o.index)].value() == value;
  }

 private:
  const Program& program_;
  std::vector<QuantityRef> inputs_;  // by flat index
  std::vector<Signed> statements_;
};

}  // namespace robcogen::symbolic
