#include "backend/common/columns.h"

#include <algorithm>

namespace robcogen::backend {

const Function& right_sides(const Library& library, const Function& function) {
  const std::string& name = function.solved->right_sides.name;
  const std::vector<Function>& all = library.right_sides;
  return *std::find_if(all.begin(), all.end(), [&](const Function& f) { return f.name == name; });
}

Function column_solution(const symbolic::SolvedColumns& solved) {
  Function function;
  function.name = function.kernel = solved.solution.name;
  function.program = solved.solution;
  return function;
}

Kernel without_lines(const Function& function, const Dialect& dialect) {
  Kernel kernel;
  kernel.name = function.kernel;
  kernel.parameters = parameters(function.program, dialect);
  return kernel;
}

symbolic::Cost count(const Library& library, const Function& function) {
  if (!function.solved) return symbolic::cost(function.program);
  symbolic::Cost all = symbolic::cost(right_sides(library, function).program);
  const symbolic::Cost one = symbolic::cost(function.solved->solution);
  for (const symbolic::SolvedColumns::Block& block : function.solved->blocks) {
    all.mul += block.columns * one.mul;
    all.add += block.columns * one.add;
    all.div += block.columns * one.div;
    all.sqrt += block.columns * one.sqrt;
  }
  return all;
}

}  // namespace robcogen::backend
