#include "pass/small_angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

#include "support/index.h"

namespace robcogen::pass {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

// The largest angle that robcogen::are_small accepts, and the largest that the polynomials are made for (rad), in
// double and in float.
struct AngleRange {
  double small, largest;
};
constexpr AngleRange kRanges[] = {{3e4, 1e5}, {120, 400}};

// The largest magnitude of each statement, for positions of magnitude up to `small`.
std::vector<double> largest_values(const Program& p, double small) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  std::vector<double> inputs, result;
  for (const symbolic::InputArray& array : p.inputs)
    inputs.insert(inputs.end(), array.elements.size(), array.role == symbolic::Role::joint_position ? small : kUnknown);
  const auto largest = [&](const Operand& o) {
    if (is_constant(o)) return std::abs(p.constants[at(o.index)].value());
    return o.kind == Operand::Kind::input ? inputs[at(o.index)] : result[at(o.index)];
  };
  for (const Statement& s : p.statements) {
    double value = kUnknown;
    if (is_sum(s.op)) value = largest(s.a) + largest(s.b);
    if (s.op == Op::multiply) value = largest(s.a) * largest(s.b);
    if (s.op == Op::gather) {
      value = 0.0;
      for (const Operand& o : s.lanes) value = std::max(value, largest(o));
    }
    result.push_back(value);
  }
  return result;
}

bool is_angle_function_in_lanes(const Statement& s) {
  return (s.op == Op::sine || s.op == Op::cosine) && s.width > 1;
}

}  // namespace

bool has_small_angles(const Program& program) {
  if (std::none_of(program.statements.begin(), program.statements.end(), is_angle_function_in_lanes)) return false;
  return std::all_of(std::begin(kRanges), std::end(kRanges), [&](const AngleRange& range) {
    const std::vector<double> largest = largest_values(program, range.small);
    return std::all_of(program.statements.begin(), program.statements.end(), [&](const Statement& s) {
      return !is_angle_function_in_lanes(s) || largest[at(s.a.index)] <= range.largest;
    });
  });
}

}  // namespace robcogen::pass
