// Rebuilds programs statement by statement in a graph: shared by algebraic passes and derivatives.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "symbolic/expression.h"

namespace robcogen::symbolic {

// The values of a program in a graph. Program and graph must outlive this object.
class Rebuild {
 public:
  // The new value of an operand, without its sign, for those that are not read from the program.
  using Replacement = std::function<std::optional<Expression>(const Operand&)>;

  Rebuild(Graph& graph, const Program& program, Replacement replacement = {});

  // The new value of an operand whose statement was rebuilt already.
  Expression read(const Operand& operand);
  // The value that statement i computes from the new values of its operands.
  Expression compute(std::size_t i);
  // Sets the new value of statement i; it inherits section and name.
  void set(std::size_t i, const Expression& value);
  // The next statements belong to the section of statement i.
  void enter_section_of(std::size_t i);
  // Rebuilds a statement as it is.
  void keep(std::size_t i);
  void keep_all();
  // The new values of each array of outputs.
  std::vector<std::vector<Expression>> outputs();
  // The program that computes the new values.
  Program finish() { return finish(program_.inputs, program_.outputs, outputs()); }
  // The same with other inputs and outputs: `values[k]` are the values of `shapes[k]`.
  Program finish(
      std::vector<InputArray> inputs,
      std::vector<OutputArray> shapes,
      const std::vector<std::vector<Expression>>& values) const;

 private:
  Graph& graph_;
  const Program& program_;
  Replacement replacement_;
  std::vector<Expression> values_;
  int section_ = -1;
};

// The outputs of a program, by array, as expressions of this graph; `inputs` has all input elements in order.
std::vector<std::vector<Expression>> outputs_of(
    Graph& graph,
    const Program& program,
    const std::vector<Expression>& inputs);

}  // namespace robcogen::symbolic
