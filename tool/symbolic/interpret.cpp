#include "symbolic/interpret.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "symbolic/apply.h"

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
  std::vector<Real> computed;      // lane by lane
  std::vector<std::size_t> start;  // place of each statement's first lane
  computed.reserve(program.statements.size());
  start.reserve(program.statements.size());

  const auto read_lane = [&](const Operand& o, int lane) {
    const auto i = static_cast<std::size_t>(o.index);
    const auto of_statement = [&] {
      const int own = o.lane >= 0 ? o.lane : program.statements[i].width > 1 ? lane : 0;
      return computed[start[i] + static_cast<std::size_t>(own)];
    };
    const Real x = is_constant(o) ? constant[i] : o.kind == Operand::Kind::input ? input[i] : of_statement();
    return o.negative ? -x : x;
  };
  const auto read = [&](const Operand& o) { return read_lane(o, 0); };
  for (const Statement& s : program.statements) {
    start.push_back(computed.size());
    if (s.op == Op::sum_lanes) {
      Real sum = read_lane(s.a, 0);
      for (int lane = 1; lane < program.statements[static_cast<std::size_t>(s.a.index)].width; ++lane)
        sum += read_lane(s.a, lane);
      computed.push_back(sum);
      continue;
    }
    for (int lane = 0; lane < s.width; ++lane)
      computed.push_back(
          s.op == Op::gather ? read(s.lanes[static_cast<std::size_t>(lane)])
                             : apply(s.op, read_lane(s.a, lane), is_binary(s.op) ? read_lane(s.b, lane) : Real(0)));
  }

  Arrays<Real> result;
  for (const OutputArray& array : program.outputs) {
    std::vector<Real>& values = result[array.name];
    values.reserve(array.values.size());
    for (const Operand& o : array.values) values.push_back(read(o));
  }
  return result;
}

template Arrays<float> interpret(const Program&, const Arrays<float>&);
template Arrays<double> interpret(const Program&, const Arrays<double>&);
template Arrays<long double> interpret(const Program&, const Arrays<long double>&);

}  // namespace robcogen::symbolic
