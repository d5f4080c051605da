// Rebuilding a program statement by statement through symbolic::Graph: what the algebraic passes share.
#pragma once

#include <vector>

#include "symbolic/expression.h"

namespace robcogen::pass {

class Rebuild {
 public:
  explicit Rebuild(const symbolic::Program& program);

  // The new value of an operand whose statement was rebuilt already.
  symbolic::Expression read(const symbolic::Operand& operand);
  // What statement i computes, from the new values of its operands.
  symbolic::Expression compute(std::size_t i);
  // Sets the new value of statement i; it inherits section and name.
  void set(std::size_t i, const symbolic::Expression& value);
  // The next statements belong to the section of statement i.
  void enter_section_of(std::size_t i);
  symbolic::Program finish();

 private:
  const symbolic::Program& program_;
  symbolic::Graph graph_;
  std::vector<symbolic::Expression> values_;
  int section_ = -1;
};

}  // namespace robcogen::pass
