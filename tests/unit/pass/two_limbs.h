// Programs of a trunk with two limbs, written by hand or random.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "pass/lanes/lane_plan.h"
#include "symbolic/programs.h"

namespace robcogen::pass::two_limbs {

using robcogen::test::program;
using symbolic::Operand;
using symbolic::Program;

// Two limbs with two joints each, on a trunk with two joints. `returns` lists the elements of the output.
inline Program limbs_program(const std::string& statements, const std::string& returns, int outputs) {
  return program(
      "program test\n"
      "input a joint_position L_hip L_knee R_hip R_knee waist neck\n"
      "output out value " +
      std::to_string(outputs) +
      " 1\n"
      "section leg legs\n"
      "in 0\n" +
      statements + "return out " + returns + "\n");
}
inline const std::vector<InputTuples> kLimbs = {{{0, 2}, {1, 3}}};

// The zero with which shorter limbs are filled up: the constant after all constants of the program.
inline Operand zero_of(const Program& p) {
  return {Operand::Kind::constant, static_cast<int>(p.constants.size()), false};
}

inline const std::vector<double> kInputs = {0.3, -1.1, 0.8, 0.7, 2.1, 0.4};

inline std::vector<double> run(const Program& p) {
  return symbolic::interpret<double>(p, {{"a", kInputs}}).at("out");
}

// Limbs that compute with the same operators on different numbers.
class RandomLimbs {
 public:
  explicit RandomLimbs(unsigned seed) : random_(seed) {}

  // Any operand of the right limb may be negated.
  Program make() {
    return make([&] { return pick(3) == 0; });
  }

  // As in a mirrored leg, each value of the right limb is that of the left limb or its negative, with the signs written
  // in its statement. Only sums and products.
  Program mirrored() {
    turned_inputs_ = {pick(2) == 0, pick(2) == 0};
    is_mirrored_ = true;
    return make([&] { return false; });
  }

 private:
  // An operand: a statement (kind 0 to 2) or an input (3) of the limb, a value of the trunk (4), or a number (5).
  struct Choice {
    int kind, index;
  };
  std::mt19937 random_;
  bool is_mirrored_ = false;
  std::vector<bool> turned_inputs_, turned_;  // negated in the right limb: inputs, statements

  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  template <class Turns>
  Program make(Turns turns) {
    std::string statements = "tmp t0 = a[4] * a[5]\ntmp t1 = t0 + a[4]\n", returns;
    const int length = 3 + pick(10);
    for (int k = 0; k < length; ++k) {
      const int kind = pick(is_mirrored_ ? 5 : 6);
      const std::string op = kind < 2 ? " + " : kind == 2 ? " - " : " * ";
      const Choice a = of_limb(k), b = kind < 3 ? of_limb(k) : factor();
      bool turn_a = turns(), turn_b = turns();
      if (is_mirrored_) {
        turned_.push_back(pick(2) == 0);
        turn_a = is_turned(a) != turned_.back();
        turn_b = is_turned(b) != (kind < 3 && turned_.back());
      }
      for (const bool right : {false, true}) {
        const std::string first = text(a, right, right && turn_a), second = text(b, right, right && turn_b);
        statements += (right ? "tmp R_t" : "tmp L_t") + std::to_string(k) + " = ";
        statements += kind == 5 ? (a.kind % 2 ? "sin " : "cos ") + first : first + op + second;
        statements += "\n";
      }
    }
    for (int k = length - 3; k < length; ++k) returns += "L_t" + std::to_string(k) + " R_t" + std::to_string(k) + " ";
    const std::string last = "_t" + std::to_string(length - 1);
    statements += "tmp s0 = L" + last + " + R" + last + "\ntmp s1 = s0 - t1\n";
    return limbs_program(statements, returns + "s1", 7);
  }

  Choice of_limb(int statements) {
    const int kind = statements == 0 ? 3 : pick(4);
    return {kind, kind < 3 ? std::max(0, statements - 1 - pick(3)) : pick(2)};
  }
  // Keeps products small.
  Choice factor() { return {3 + pick(3), pick(2)}; }

  bool is_turned(const Choice& c) const {
    const auto index = static_cast<std::size_t>(c.index);
    return c.kind < 3 ? turned_[index] : c.kind == 3 && turned_inputs_[index];
  }
  static std::string text(const Choice& c, bool right, bool negative) {
    const std::string sign = negative ? "-" : "", index = std::to_string(c.index);
    if (c.kind < 3) return sign + (right ? "R_t" : "L_t") + index;
    if (c.kind == 3) return sign + "a[" + std::to_string(c.index + (right ? 2 : 0)) + "]";
    if (c.kind == 4) return sign + "t" + index;
    return sign + (right ? "0.75" : "0.5");
  }
};

}  // namespace robcogen::pass::two_limbs
