// Names that say what the values of a program are: names given by the algorithm, and names that follow from those of
// the operands.
#pragma once

#include <string>
#include <vector>

#include "support/index.h"
#include "symbolic/program.h"

namespace robcogen::symbolic {

// Longer names make lines that are hard to read.
inline constexpr std::size_t kLongestQuantityName = 28;

// The name of a value without its sign, and the sign.
struct Quantity {
  std::string name;  // empty if nothing is known about the value
  bool negative = false;
};

// The name with the sign: `hip_wx_neg`.
std::string text(const Quantity& quantity);

// A name such as `hip_wx`, split into link and quantity.
struct NameParts {
  std::string subject, quantity;
};

NameParts parts_of(const std::string& name);

// The quantities of the inputs and statements of a program.
class QuantityNames {
 public:
  explicit QuantityNames(const Program& program);

  const Program& program() const { return program_; }
  std::size_t size() const { return statements_.size(); }
  const Quantity& operator[](std::size_t statement) const { return statements_[statement]; }
  Quantity of(const Operand& o) const;

  const Statement* statement(const Operand& o) const {
    return is_statement(o) ? &program_.statements[at(o.index)] : nullptr;
  }
  bool is_number(const Operand& o, double value) const {
    return is_constant(o) && program_.constants[at(o.index)].value() == value;
  }

 private:
  const Program& program_;
  std::vector<std::string> inputs_;  // by flat index
  std::vector<Quantity> statements_;
};

}  // namespace robcogen::symbolic
