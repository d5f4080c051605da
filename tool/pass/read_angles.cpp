#include "pass/read_angles.h"

#include <optional>

#include "support/index.h"
#include "symbolic/apply.h"

namespace robcogen::pass {
namespace {

using symbolic::Expression;
using symbolic::InputArray;
using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Role;
using symbolic::Statement;

// The values of a program, lane by lane, as far as they depend on parameters and joint positions only.
class Values {
 public:
  explicit Values(const Program& program) {
    std::size_t count = 0;
    for (const Statement& s : program.statements) {
      first_.push_back(count);
      count += at(s.width);
    }
    values_.resize(count);
  }
  std::optional<Expression>& of(std::size_t statement, int lane) { return values_[first_[statement] + at(lane)]; }

 private:
  std::vector<std::size_t> first_;  // by statement
  std::vector<std::optional<Expression>> values_;
};

class AngleReader {
 public:
  AngleReader(const Program& program, AngleTable& angles)
      : program_(program),
        angles_(angles),
        q_(place_of(program, Role::joint_position)),
        parameters_(place_of(program, Role::parameters)),
        values_(program) {}

  Readings run() {
    Readings readings(program_.statements.size());
    for (std::size_t i = 0; i < program_.statements.size(); ++i) {
      const Statement& s = program_.statements[i];
      for (int lane = 0; lane < s.width; ++lane) {
        const std::optional<Expression> a = read(s.op == Op::gather ? s.lanes[at(lane)] : s.a, lane);
        if (s.op != Op::sine && s.op != Op::cosine) {
          values_.of(i, lane) = compute(s, a, lane);
        } else if (const auto k = a ? angles_.number(*a) : std::nullopt) {
          readings[i].push_back({*k, a->negative()});
        }
      }
      if (readings[i].size() < at(s.width)) readings[i].clear();
    }
    return readings;
  }

 private:
  const Program& program_;
  AngleTable& angles_;
  const InputPlace q_, parameters_;
  Values values_;

  // One lane of a statement whose first operand is `a` in that lane.
  std::optional<Expression> compute(const Statement& s, std::optional<Expression> a, int lane) {
    if (s.op == Op::gather || !a) return a;
    const auto b = symbolic::is_binary(s.op) ? read(s.b, lane) : Expression();
    if (!b || s.op == Op::sum_lanes) return std::nullopt;
    return symbolic::apply(s.op, *a, *b);
  }

  // An operand of a value with lanes, in one of its lanes.
  std::optional<Expression> read(const Operand& o, int lane) {
    std::optional<Expression> value;
    if (is_constant(o)) value = angles_.sums().graph().constant(program_.constants[at(o.index)]);
    if (is_statement(o)) {
      const bool is_scalar = program_.statements[at(o.index)].width == 1;
      value = values_.of(at(o.index), is_scalar ? 0 : o.lane >= 0 ? o.lane : lane);
    }
    if (o.kind == Operand::Kind::input) {
      if (q_.contains(o.index)) value = angles_.sums().position(o.index - q_.begin);
      if (parameters_.contains(o.index)) value = angles_.sums().parameter(o.index - parameters_.begin);
    }
    if (value && o.negative) value = -*value;
    return value;
  }
};

}  // namespace

Readings read_angles(const Program& program, AngleTable& angles) {
  return AngleReader(program, angles).run();
}

InputPlace place_of(const Program& program, Role role) {
  int begin = 0;
  for (const InputArray& array : program.inputs) {
    if (array.role == role) return {&array, begin};
    begin += static_cast<int>(array.elements.size());
  }
  return {};
}

}  // namespace robcogen::pass
