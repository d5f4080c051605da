// Programs for tests: read from text, written as text, or random.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "symbolic/interpret.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"

namespace robcogen::test {

inline symbolic::Program program(const std::string& text) {
  std::string error;
  std::optional<symbolic::Program> p = symbolic::parse(text, error);
  EXPECT_TRUE(p) << error << "\n" << text;
  return p.value_or(symbolic::Program());
}

// The head of small programs: inputs a[0] … a[3], one output `out`, two sections.
inline std::string head(int outputs = 1) {
  return "program test\n"
         "input a value 0 1 2 3\n"
         "output out value " +
         std::to_string(outputs) +
         " 1\n"
         "section hip link hip\n"
         "section knee link knee\n";
}

inline symbolic::Program small_program(const std::string& statements, int outputs = 1) {
  return program(head(outputs) + statements);
}

// A value and a bound on the rounding errors that it may carry, in whichever order its sums and products are computed.
struct Bounded {
  long double value = 0;
  long double error = 0;
};

// Textbook running error analysis (Higham 2002, ch. 3) with 2^-52, twice the unit roundoff of double: an evaluator of
// programs that shares nothing with the interpreter.
class BoundedEvaluator {
 public:
  explicit BoundedEvaluator(const symbolic::Program& p, const std::vector<double>& inputs) : p_(p), inputs_(inputs) {
    for (const symbolic::Statement& s : p.statements) computed_.push_back(statement(s));
  }

  Bounded operator()(const symbolic::Operand& o) const {
    const auto i = static_cast<std::size_t>(o.index);
    Bounded b;
    switch (o.kind) {
      case symbolic::Operand::Kind::constant:
        b = rounded(p_.constants[i].value(), 0);
        break;
      case symbolic::Operand::Kind::input:
        b = {inputs_[i], 0};
        break;
      case symbolic::Operand::Kind::statement:
        b = computed_[i];
        break;
    }
    if (o.negative) b.value = -b.value;
    return b;
  }

 private:
  const symbolic::Program& p_;
  const std::vector<double>& inputs_;
  std::vector<Bounded> computed_;

  static Bounded rounded(long double value, long double error) {
    constexpr long double kUnit = 0x1p-52L;
    return {value, error + kUnit * std::abs(value)};
  }

  Bounded statement(const symbolic::Statement& s) const {
    using symbolic::Op;
    const Bounded a = (*this)(s.a), b = is_binary(s.op) ? (*this)(s.b) : Bounded();
    const long double magnitudes = std::abs(a.value) + std::abs(b.value);
    switch (s.op) {
      case Op::add:
        return rounded(a.value + b.value, a.error + b.error + 0x1p-52L * magnitudes);
      case Op::subtract:
        return rounded(a.value - b.value, a.error + b.error + 0x1p-52L * magnitudes);
      case Op::multiply:
        return rounded(
            a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
      case Op::divide: {
        const long double quotient = a.value / b.value;
        return rounded(quotient, 2 * (a.error + std::abs(quotient) * b.error) / std::abs(b.value));
      }
      case Op::square_root: {
        const long double root = std::sqrt(a.value);
        return rounded(root, a.error / root);
      }
      case Op::sine:
        return rounded(std::sin(a.value), a.error);
      case Op::cosine:
        return rounded(std::cos(a.value), a.error);
      case Op::arc_tangent:
        return rounded(std::atan2(a.value, b.value), (a.error + b.error) / std::hypot(a.value, b.value));
      case Op::gather:
      case Op::sum_lanes:
        break;  // only in programs with lanes
    }
    return {};
  }
};

// Programs with everything that folds: zeros, ones, equal and opposite operands, multiples of PI, sums of sums,
// products of products, dead and repeated statements. Divisors and radicands are at least 1.
class RandomPrograms {
 public:
  static constexpr int kInputs = 4;

  explicit RandomPrograms(unsigned seed) : random_(seed) {}

  symbolic::Program make() {
    symbolic::Program p;
    p.name = "random";
    p.inputs = {{"a", symbolic::Role::value, {"0", "1", "2", "3"}}};
    p.constants = {
        Number(),
        Number(1.0),
        Number(0.5),
        *Number::parse("0.1"),
        Number(3.0),
        Number::rational(1, 3),
        Number::pi_multiple(1, 2),
        Number::pi_multiple(1, 3),
        Number::pi_multiple(2)};
    p.sections = {{"one", "one"}, {"two", "two"}, {"three", "one"}};
    for (int k = 5 + pick(40); k > 0; --k) append(p);
    p.outputs = {{"out", symbolic::Role::value, 3, 2, {}}};
    for (int k = 0; k < 6; ++k) p.outputs[0].values.push_back(operand(p));
    return p;
  }

  std::vector<double> inputs() {
    std::vector<double> values;
    for (int k = 0; k < kInputs; ++k) values.push_back(std::uniform_real_distribution<double>(-1.5, 1.5)(random_));
    return values;
  }

 private:
  std::mt19937 random_;
  int section_ = 0;

  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  symbolic::Operand operand(const symbolic::Program& p) {
    using Kind = symbolic::Operand::Kind;
    const int count = static_cast<int>(p.statements.size());
    const bool negative = pick(3) == 0;
    const int choice = pick(10);
    if (choice == 0) return {Kind::constant, pick(static_cast<int>(p.constants.size())), negative};
    if (choice < 4 || count == 0) return {Kind::input, pick(kInputs), negative};
    // Mostly recent statements, so that sums of sums and products of products occur.
    return {Kind::statement, std::max(0, count - 1 - pick(pick(4) == 0 ? count : 4)), negative};
  }

  int push(symbolic::Program& p, symbolic::Op op, symbolic::Operand a, symbolic::Operand b) {
    if (pick(6) == 0) section_ = pick(3);
    symbolic::Statement s{op, a, b, "s" + std::to_string(p.statements.size()), section_, pick(6) == 0};
    if (!is_binary(op)) s.b = {};
    if (s.named) s.quantity = std::make_shared<const symbolic::Quantity>(symbolic::Quantity{s.name});
    p.statements.push_back(std::move(s));
    return static_cast<int>(p.statements.size()) - 1;
  }

  // 1 + sin^2 of an operand: a value in [1, 2] that the passes cannot recognise as such.
  symbolic::Operand at_least_one(symbolic::Program& p) {
    using symbolic::Op;
    using Kind = symbolic::Operand::Kind;
    const symbolic::Operand sine{Kind::statement, push(p, Op::sine, operand(p), {}), false};
    const symbolic::Operand square{Kind::statement, push(p, Op::multiply, sine, sine), false};
    return {Kind::statement, push(p, Op::add, square, {Kind::constant, 1, false}), false};
  }

  void append(symbolic::Program& p) {
    using symbolic::Op;
    switch (pick(14)) {
      case 0:
        push(p, Op::sine, operand(p), {});
        break;
      case 1:
        push(p, Op::cosine, operand(p), {});
        break;
      case 2:
        push(p, Op::square_root, at_least_one(p), {});
        break;
      case 3: {
        const symbolic::Operand divisor = at_least_one(p);
        push(p, Op::divide, operand(p), {divisor.kind, divisor.index, pick(2) == 0});
        break;
      }
      case 4:
      case 5:
      case 6:
      case 7: {
        // Products stay small, because one factor is an input or a constant.
        const symbolic::Operand factor =
            pick(2) == 0 ? symbolic::Operand{symbolic::Operand::Kind::input, pick(kInputs), pick(2) == 0}
                         : symbolic::Operand{symbolic::Operand::Kind::constant, pick(6), pick(2) == 0};
        push(p, Op::multiply, factor, operand(p));
        break;
      }
      default:
        push(p, pick(2) == 0 ? Op::add : Op::subtract, operand(p), operand(p));
    }
  }
};

// Compares the results of both programs up to rounding; returns a description of the first difference, or nothing.
inline std::string difference(
    const symbolic::Program& original,
    const symbolic::Program& changed,
    const std::vector<double>& inputs) {
  // Rewriting at most doubles the rounding errors that the bound counts; 4 leaves a margin.
  constexpr long double kMargin = 4;
  const BoundedEvaluator expected(original, inputs);
  const symbolic::Arrays<double> computed = symbolic::interpret<double>(changed, {{"a", inputs}});
  for (const symbolic::OutputArray& array : original.outputs) {
    for (std::size_t k = 0; k < array.values.size(); ++k) {
      const Bounded wanted = expected(array.values[k]);
      const double value = computed.at(array.name)[k];
      if (std::abs(value - wanted.value) <= kMargin * wanted.error + 1e-300L) continue;
      return array.name + "[" + std::to_string(k) + "] = " + std::to_string(value) + " instead of " +
             std::to_string(static_cast<double>(wanted.value));
    }
  }
  return "";
}

}  // namespace robcogen::test
