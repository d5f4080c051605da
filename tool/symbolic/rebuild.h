// Rebuilds a program statement by statement through Graph: shared by algebraic passes and derivatives.
#pragma once

#include <vector>

#include "symbolic/expression.h"

namespace robcogen::symbolic {

// The program must outlive this object.
class Rebuild {
 public:
  explicit Rebuild(const Program& program) : Rebuild(program, program.inputs.size(), {}) {}
  // Adds another input array in front of the input array `place`, unless it has no elements.
  Rebuild(const Program& program, std::size_t place, const InputArray& added);

  Graph graph;

  // An element of the program's inputs, and one of the added array.
  Expression input(int element) { return graph.input(element < place_ ? element : element + added_); }
  Expression added_input(int element) { return graph.input(place_ + element); }
  // The new value of an operand whose statement was rebuilt already.
  Expression read(const Operand& operand);
  // The value that statement i computes from the new values of its operands.
  Expression compute(std::size_t i);
  // Sets the new value of statement i; it inherits section and name.
  void set(std::size_t i, const Expression& value);
  // The next statements belong to the section of statement i.
  void enter_section_of(std::size_t i);
  // Rebuilds every statement as it is.
  void keep_all();
  // The new values of each array of outputs.
  std::vector<std::vector<Expression>> outputs();
  // The program that computes the new values.
  Program finish() { return finish(program_.outputs, outputs()); }
  // The same with other outputs: `values[k]` are the values of `shapes[k]`.
  Program finish(std::vector<OutputArray> shapes, const std::vector<std::vector<Expression>>& values) const;

 private:
  const Program& program_;
  std::vector<InputArray> inputs_;
  int place_ = 0, added_ = 0;  // of the added array: its first element, its size
  std::vector<Expression> values_;
  int section_ = -1;
};

// The outputs of a program, by array, as expressions of this graph; `inputs` has all input elements in order.
std::vector<std::vector<Expression>> outputs_of(
    Graph& graph,
    const Program& program,
    const std::vector<Expression>& inputs);

}  // namespace robcogen::symbolic
