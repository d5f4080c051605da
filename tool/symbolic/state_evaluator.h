// Runs programs in a few states at once: in double, in float, and with 32 digits. The states are the same for all
// programs of a function, and on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "support/index.h"
#include "symbolic/double_double.h"
#include "symbolic/program.h"

namespace robcogen::symbolic {

inline constexpr std::size_t kStates = 16;

// A value in all states.
template <class Real>
struct Batch {
  std::array<Real, kStates> value;
};
template <>
struct Batch<DoubleDouble> {
  std::array<double, kStates> high, low;
};

template <class Real>
Real get(const Batch<Real>& batch, std::size_t state) {
  if constexpr (std::is_same_v<Real, DoubleDouble>)
    return {batch.high[state], batch.low[state]};
  else
    return batch.value[state];
}

template <class Real>
void set(Batch<Real>& batch, std::size_t state, const Real& value) {
  if constexpr (std::is_same_v<Real, DoubleDouble>) {
    batch.high[state] = value.high;
    batch.low[state] = value.low;
  } else {
    batch.value[state] = value;
  }
}

template <class Real>
Real rounded(const DoubleDouble& x) {
  if constexpr (std::is_same_v<Real, DoubleDouble>)
    return x;
  else
    return static_cast<Real>(x.high);
}

// An integer with all its digits.
DoubleDouble exact(std::int64_t n);

// The value of a literal. As in the generated code it is rounded to double, also in the reference; multiples of PI are
// exact there.
template <class Real>
Real literal_as(const Number& n) {
  if constexpr (std::is_same_v<Real, DoubleDouble>) {
    if (!n.is_pi_multiple()) return {n.value(), 0.0};
    return kPiPair * (exact(n.ratio()->num) / exact(n.ratio()->den));
  } else {
    return static_cast<Real>(n.value());
  }
}

// The value of an input element in a state. `parameters`: the values of the input with the role `parameters`; missing
// ones are one.
double input_of(const InputArray& array, std::size_t element, std::size_t state, const std::vector<double>& parameters);

// Runs programs in all states at once.
template <class Real>
class StateEvaluator {
 public:
  using Values = Batch<Real>;

  StateEvaluator(const Program& program, const std::vector<double>& parameters) : program_(program) {
    for (const InputArray& array : program.inputs) {
      for (std::size_t k = 0; k < array.elements.size(); ++k) {
        Values& input = inputs_.emplace_back();
        for (std::size_t s = 0; s < kStates; ++s)
          set(input, s, rounded<Real>({input_of(array, k, s, parameters), 0.0}));
      }
    }
    for (const Constant& c : program.constants) {
      Values& constant = constants_.emplace_back();
      for (std::size_t s = 0; s < kStates; ++s) set(constant, s, literal_as<Real>(c.number()));
    }
    first_.reserve(program.statements.size());
    computed_.reserve(program.statements.size());
    for (const Statement& statement : program.statements) run(statement);
  }

  Values read(const Operand& o, int lane = 0) const {
    Values x = whole(o, lane);
    if (o.negative)
      for (std::size_t s = 0; s < kStates; ++s) set(x, s, -get(x, s));
    return x;
  }

 private:
  const Program& program_;
  std::vector<Values> inputs_, constants_;
  std::vector<Values> computed_;    // lane by lane
  std::vector<std::size_t> first_;  // first lane of each statement

  const Values& whole(const Operand& o, int lane) const {
    const std::size_t i = at(o.index);
    if (is_constant(o)) return constants_[i];
    if (o.kind == Operand::Kind::input) return inputs_[i];
    const int own = o.lane >= 0 ? o.lane : program_.statements[i].width > 1 ? lane : 0;
    return computed_[first_[i] + at(own)];
  }

  void run(const Statement& s) {
    first_.push_back(computed_.size());
    if (s.op == Op::sum_lanes) {
      Values sum = read(s.a, 0);
      for (int lane = 1; lane < program_.statements[at(s.a.index)].width; ++lane)
        sum = combined(Op::add, sum, read(s.a, lane));
      computed_.push_back(sum);
      return;
    }
    for (int lane = 0; lane < s.width; ++lane) {
      if (s.op == Op::gather)
        computed_.push_back(read(s.lanes[at(lane)]));
      else if (is_binary(s.op))
        computed_.push_back(combined(s.op, read(s.a, lane), read(s.b, lane)));
      else
        computed_.push_back(function(s.op, read(s.a, lane)));
    }
  }

  template <class F>
  static Values each(const Values& a, const Values& b, F f) {
    Values result;
    for (std::size_t s = 0; s < kStates; ++s) set(result, s, f(get(a, s), get(b, s)));
    return result;
  }

  static Values combined(Op op, const Values& a, const Values& b) {
    switch (op) {
      case Op::add:
        return each(a, b, [](const Real& x, const Real& y) { return x + y; });
      case Op::subtract:
        return each(a, b, [](const Real& x, const Real& y) { return x - y; });
      case Op::multiply:
        return each(a, b, [](const Real& x, const Real& y) { return x * y; });
      case Op::divide:
        return each(a, b, [](const Real& x, const Real& y) { return x / y; });
      case Op::arc_tangent:
        return each(a, b, [](const Real& x, const Real& y) {
          using std::atan2;
          return atan2(x, y);
        });
      default:
        throw std::logic_error("not an operation on two numbers");
    }
  }

  static Values function(Op op, const Values& a) {
    using std::sqrt;
    Values result;
    for (std::size_t s = 0; s < kStates; ++s) {
      const Real x = get(a, s);
      if (op == Op::square_root) {
        set(result, s, sqrt(x));
        continue;
      }
      DoubleDouble angle;
      if constexpr (std::is_same_v<Real, DoubleDouble>)
        angle = x;
      else
        angle.high = static_cast<double>(x);
      const SineCosine both = sine_cosine(angle);
      set(result, s, rounded<Real>(op == Op::sine ? both.sine : both.cosine));
    }
    return result;
  }
};

}  // namespace robcogen::symbolic
