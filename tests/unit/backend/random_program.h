// Random programs for the tests of lowering.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "symbolic/program.h"

namespace robcogen::test {

// Programs with everything that may occur: any operation on any operand, signs anywhere, names that clash, sections
// that recur, and output elements that are inputs, constants, equal or of opposite sign.
class RandomProgram {
 public:
  explicit RandomProgram(unsigned seed) : random_(seed) {}

  symbolic::Program make() {
    symbolic::Program p;
    p.name = "random";
    p.inputs = {
        {"q", symbolic::Role::joint_position, {"HFE", "hfe", "class"}}, {"qd", symbolic::Role::value, {"a", "b"}}};
    for (int k = pick(4); k >= 0; --k) p.constants.push_back(Number(std::ldexp(1 + pick(1000), -pick(12))));
    for (int k = pick(3); k >= 0; --k) p.sections.push_back({"part " + std::to_string(k), "t"});
    for (int k = pick(60); k >= 0; --k) p.statements.push_back(statement(p));
    for (const char* name : {"tau", "H"}) {
      symbolic::OutputArray array{name, symbolic::Role::value, pick(8), 1, {}};
      for (int k = 0; k < array.rows; ++k) array.values.push_back(operand(p));
      p.outputs.push_back(std::move(array));
    }
    return p;
  }

  double value() { return std::uniform_real_distribution<double>(-2, 2)(random_); }

 private:
  std::mt19937 random_;

  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  symbolic::Operand operand(const symbolic::Program& p) {
    symbolic::Operand o;
    o.negative = pick(4) == 0;
    const int count = static_cast<int>(p.statements.size());
    switch (count == 0 ? pick(2) : pick(8)) {
      case 0:
        o.kind = symbolic::Operand::Kind::constant;
        o.index = pick(static_cast<int>(p.constants.size()));
        return o;
      case 1:
        o.kind = symbolic::Operand::Kind::input;
        o.index = pick(p.input_count());
        return o;
      default:  // mostly recent statements, so that expressions grow deep
        o.kind = symbolic::Operand::Kind::statement;
        o.index = std::max(0, count - 1 - pick(pick(3) == 0 ? count : 3));
        return o;
    }
  }

  symbolic::Statement statement(const symbolic::Program& p) {
    const symbolic::Op ops[] = {symbolic::Op::add,         symbolic::Op::subtract, symbolic::Op::multiply,
                                symbolic::Op::multiply,    symbolic::Op::add,      symbolic::Op::subtract,
                                symbolic::Op::square_root, symbolic::Op::sine,     symbolic::Op::cosine,
                                symbolic::Op::divide};
    symbolic::Statement s;
    s.op = ops[pick(10)];
    s.a = operand(p);
    s.b = operand(p);
    const std::string number = std::to_string(p.statements.size());
    s.name = pick(10) == 0 ? "q_" + number : "left_front_upperleg_t" + number;
    s.section = pick(static_cast<int>(p.sections.size()));
    s.named = pick(5) == 0;
    if (s.named) s.quantity = std::make_shared<const symbolic::Quantity>(symbolic::Quantity{s.name});
    return s;
  }
};

}  // namespace robcogen::test
