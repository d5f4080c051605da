// Runs programs without a compiler. The scalars are numbers (`robcogen eval`, the property tests), numbers in many
// states at once (states.h), or expressions (rebuild.h).
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/index.h"
#include "symbolic/apply.h"
#include "symbolic/program.h"

namespace robcogen::symbolic {

// Computes the statements of a program in their order. `leaf(operand)` is the value of a constant or of an input
// element, without the sign of the operand. The program must outlive this object.
template <class Scalar, class Leaf>
class Interpreter {
 public:
  Interpreter(const Program& program, Leaf leaf) : program_(program), leaf_(std::move(leaf)) {
    first_.reserve(program.statements.size());
    computed_.reserve(program.statements.size());
    for (const Statement& s : program.statements) run(s);
  }

  // An operand in one of its lanes. A scalar is the same in all of them.
  Scalar read(const Operand& o, int lane = 0) const {
    return with(o, lane, [](const Scalar& x) { return x; });
  }

  // The values of each array of outputs.
  std::vector<std::vector<Scalar>> outputs() const {
    std::vector<std::vector<Scalar>> result;
    for (const OutputArray& array : program_.outputs) {
      std::vector<Scalar>& values = result.emplace_back();
      values.reserve(array.values.size());
      for (const Operand& o : array.values) values.push_back(read(o));
    }
    return result;
  }

 private:
  const Program& program_;
  const Leaf leaf_;
  std::vector<Scalar> computed_;    // lane by lane
  std::vector<std::size_t> first_;  // first lane of each statement

  // f of an operand, which is copied only if it is negated.
  template <class F>
  Scalar with(const Operand& o, int lane, F f) const {
    const auto with_sign = [&](const Scalar& x) { return o.negative ? f(-x) : f(x); };
    if (!is_statement(o)) return with_sign(leaf_(o));
    const int own = o.lane >= 0 ? o.lane : program_.statements[at(o.index)].width > 1 ? lane : 0;
    return with_sign(computed_[first_[at(o.index)] + at(own)]);
  }

  void run(const Statement& s) {
    first_.push_back(computed_.size());
    if (s.op == Op::sum_lanes) {
      Scalar sum = read(s.a);
      for (int lane = 1; lane < width_of(program_, s.a); ++lane) sum = sum + read(s.a, lane);
      computed_.push_back(std::move(sum));
      return;
    }
    for (int lane = 0; lane < s.width; ++lane)
      computed_.push_back(s.op == Op::gather ? read(s.lanes[at(lane)]) : computed(s, lane));
  }

  // The operands are read one after the other, so that every compiler creates expressions in the order of the program.
  Scalar computed(const Statement& s, int lane) const {
    return with(s.a, lane, [&](const Scalar& a) {
      if (!is_binary(s.op)) return apply(s.op, a, a);
      return with(s.b, lane, [&](const Scalar& b) { return apply(s.op, a, b); });
    });
  }
};

template <class Scalar, class Leaf>
Interpreter<Scalar, Leaf> interpreter(const Program& program, Leaf leaf) {
  return {program, std::move(leaf)};
}

// Values by array name; each array has the declared length (matrices column by column).
template <class Real>
using Arrays = std::map<std::string, std::vector<Real>>;

// Missing input arrays count as zero; an array of the wrong length or an unknown name is an internal fault
// (std::logic_error): callers check user input first. Real is float, double or long double.
template <class Real>
Arrays<Real> interpret(const Program& program, const Arrays<Real>& inputs);

extern template Arrays<float> interpret(const Program&, const Arrays<float>&);
extern template Arrays<double> interpret(const Program&, const Arrays<double>&);
extern template Arrays<long double> interpret(const Program&, const Arrays<long double>&);

}  // namespace robcogen::symbolic
