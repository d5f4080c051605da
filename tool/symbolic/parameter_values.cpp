#include "symbolic/parameter_values.h"

#include <algorithm>
#include <cstddef>

#include "support/index.h"

namespace robcogen::symbolic {

std::vector<char> follow_from_parameters(const Program& p) {
  std::vector<char> result(p.statements.size(), false), is_parameter;
  for (const InputArray& array : p.inputs)
    is_parameter.insert(is_parameter.end(), array.elements.size(), array.role == Role::parameters);
  if (std::find(is_parameter.begin(), is_parameter.end(), true) == is_parameter.end()) return result;
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    bool follows = true;
    for_each_operand(p.statements[i], [&](const Operand& o) {
      follows = follows && (is_constant(o) || (is_statement(o) ? result : is_parameter)[at(o.index)]);
    });
    result[i] = follows;
  }
  return result;
}

}  // namespace robcogen::symbolic
