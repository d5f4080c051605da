#include "symbolic/interpret.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace robcogen::symbolic {
namespace {

// Constants that are exact multiples of PI get the precision of Real; all others are the nearest double, as in the
// generated code.
template <class Real>
Real value_of(const Number& n) {
  if (!n.is_pi_multiple()) return static_cast<Real>(n.value());
  const Real pi = std::acos(Real(-1));
  return pi * static_cast<Real>(n.ratio()->num) / static_cast<Real>(n.ratio()->den);
}

template <class Real>
std::vector<Real> flatten(const Program& program, const Arrays<Real>& inputs) {
  for (const auto& [name, values] : inputs) {
    const auto has_name = [&wanted = name](const InputArray& array) { return array.name == wanted; };
    if (std::none_of(program.inputs.begin(), program.inputs.end(), has_name))
      throw std::logic_error("the program has no input '" + name + "'");
  }
  std::vector<Real> flat;
  flat.reserve(static_cast<std::size_t>(program.input_count()));
  for (const InputArray& array : program.inputs) {
    const auto given = inputs.find(array.name);
    if (given == inputs.end()) {
      flat.resize(flat.size() + array.elements.size(), Real(0));
      continue;
    }
    if (given->second.size() != array.elements.size())
      throw std::logic_error("input '" + array.name + "' has the wrong length");
    flat.insert(flat.end(), given->second.begin(), given->second.end());
  }
  return flat;
}

}  // namespace

template <class Real>
Arrays<Real> interpret(const Program& program, const Arrays<Real>& inputs) {
  const std::vector<Real> input = flatten(program, inputs);
  std::vector<Real> constant;
  constant.reserve(program.constants.size());
  for (const Constant& c : program.constants) constant.push_back(value_of<Real>(c.number()));
  const auto leaf = [&](const Operand& o) { return (is_constant(o) ? constant : input)[at(o.index)]; };
  std::vector<std::vector<Real>> outputs = interpreter<Real>(program, leaf).outputs();
  Arrays<Real> result;
  for (std::size_t k = 0; k < outputs.size(); ++k) result[program.outputs[k].name] = std::move(outputs[k]);
  return result;
}

template Arrays<float> interpret(const Program&, const Arrays<float>&);
template Arrays<double> interpret(const Program&, const Arrays<double>&);
template Arrays<long double> interpret(const Program&, const Arrays<long double>&);

}  // namespace robcogen::symbolic
