#include "pass/lanes/lane_program.h"

#include <map>
#include <utility>

#include "pass/lanes/lane_builder.h"
#include "pass/pair_sums.h"
#include "support/index.h"

namespace robcogen::pass {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

class LaneProgramBuilder {
 public:
  LaneProgramBuilder(const Program& p, const LanePlan& plan, const std::vector<unsigned>& signs, LaneBuilder& builder)
      : p_(p),
        plan_(plan),
        signs_(signs),
        builder_(builder),
        scalars_(plan.scalars.size()),
        packed_(plan.packed_values.size()) {}

  Program run() {
    for (const int node : plan_.order)
      if (node >= plan_.scalar_count())
        compute_packed(at(node - plan_.scalar_count()));
      else
        compute_scalar(node);
    for (const Part& root : plan_.roots) make_root(root);
    std::vector<std::vector<Operand>> outputs;
    for (const symbolic::OutputArray& array : p_.outputs) {
      outputs.emplace_back();
      for (const Operand& o : array.values) outputs.back().push_back(output(o));
    }
    return builder_.program(outputs);
  }

 private:
  // A value some of whose lanes are negated.
  struct Lanes {
    Operand value;
    unsigned negated = 0;
  };

  const Program& p_;
  const LanePlan& plan_;
  const std::vector<unsigned>& signs_;  // by packed value: the lanes that are kept negated
  LaneBuilder& builder_;
  std::vector<Operand> scalars_, packed_;  // the new operands
  std::map<std::pair<int, unsigned>, Operand> flipped_;
  std::map<int, Lanes> roots_;  // by packed value: the value that outputs read in its place

  const PackedValue& packed_value(const Part& part) const { return plan_.packed_values[at(part.packed_value)]; }
  bool is_numbers(const Part& part) const { return packed_value(part).kind == PackedValue::Kind::numbers; }

  // The value of a scalar operand of the old program.
  Operand scalar(const Operand& o) {
    if (!is_statement(o)) return o;
    const LanePlan::Scalar& s = plan_.scalars[at(o.index)];
    Operand result = s.packed_value < 0 ? scalars_[at(o.index)]
                                        : lane({packed_[at(s.packed_value)], signs_[at(s.packed_value)]}, s.lane);
    result.negative = result.negative != o.negative;
    return result;
  }

  Operand lane(const Lanes& lanes, int lane) {
    Operand result = lanes.value;
    if (builder_.width(result) > 1) result.lane = lane;
    if (lanes.negated >> lane & 1U) result.negative = !result.negative;
    return result;
  }

  // The value of an element of an output.
  Operand output(const Operand& o) {
    if (!is_statement(o)) return o;
    const LanePlan::Scalar& s = plan_.scalars[at(o.index)];
    const auto root = roots_.find(s.packed_value);
    if (root == roots_.end()) return scalar(o);
    Operand result = lane(root->second, s.lane);
    result.negative = result.negative != o.negative;
    return result;
  }

  // If lanes are kept with signs other than those of the outputs, all of them change sign at once: that costs less than
  // one by one, and values with the same sign in all lanes can be stored as a vector.
  void make_root(const Part& root) {
    const PackedValue& w = plan_.packed_values[at(root.packed_value)];
    const unsigned change = (signs_[at(root.packed_value)] ^ root.negated_lanes) & all_lanes(w);
    const bool is_operation = w.kind == PackedValue::Kind::operation || w.kind == PackedValue::Kind::sum;
    if (!is_operation || change == 0 || change == all_lanes(w)) return;
    builder_.begin(w.lanes, w.place);
    const unsigned negated = root.negated_lanes & all_lanes(w);
    roots_.emplace(root.packed_value, Lanes{use(root.packed_value, negated), negated});
  }

  // The packed value with these lanes negated.
  Operand use(int packed_value, unsigned negated_lanes) {
    const PackedValue& w = plan_.packed_values[at(packed_value)];
    if (w.kind == PackedValue::Kind::numbers) return builder_.numbers(w.lanes, negated_lanes & all_lanes(w));
    const bool is_leaf = w.kind == PackedValue::Kind::broadcast || w.kind == PackedValue::Kind::gather;
    unsigned change = (negated_lanes ^ (is_leaf ? 0U : signs_[at(packed_value)])) & all_lanes(w);
    const bool negative = change & 1U;
    if (negative) change ^= all_lanes(w);
    Operand result = packed_[at(packed_value)];
    if (change) {
      const auto known = flipped_.find({packed_value, change});
      if (known != flipped_.end()) {
        result = known->second;
      } else {
        const Tuple ones(at(w.width), builder_.constant(Number(1.0)));
        result = builder_.product(result, builder_.numbers(ones, change));
        flipped_.emplace(std::pair(packed_value, change), result);
      }
    }
    result.negative = result.negative != negative;
    return result;
  }

  void compute_packed(std::size_t index) {
    const PackedValue& w = plan_.packed_values[index];
    Operand& made = packed_[index];
    builder_.begin(w.lanes, w.place);
    switch (w.kind) {
      case PackedValue::Kind::numbers:
        return;  // made where they are used
      case PackedValue::Kind::broadcast:
        made = scalar(w.lanes.front());
        return;
      case PackedValue::Kind::gather: {
        Tuple lanes;
        for (const Operand& o : w.lanes) lanes.push_back(scalar(o));
        made = builder_.gather(std::move(lanes));
        return;
      }
      case PackedValue::Kind::sum: {
        std::vector<Operand> terms;
        for (const Part& part : w.parts) terms.push_back(use(part.packed_value, signs_[index] ^ part.negated_lanes));
        made = builder_.sum(std::move(terms));
        break;
      }
      case PackedValue::Kind::operation:
        made = operation(w, signs_[index]);
        break;
    }
    if (!w.lanes.empty()) builder_.name(made, w.lanes);
  }

  Operand operation(const PackedValue& w, unsigned sign) {
    const Part a = w.parts[0];
    const auto own = [&](const Part& part) { return signs_[at(part.packed_value)]; };
    if (symbolic::is_binary(w.op)) {
      const Part b = w.parts[1];
      const unsigned both = sign ^ a.negated_lanes ^ b.negated_lanes;
      const unsigned of_a = is_numbers(a) ? both ^ own(b) : own(a);
      const Operand first = use(a.packed_value, of_a), second = use(b.packed_value, both ^ of_a);
      return w.op == Op::multiply ? builder_.product(first, second) : builder_.quotient(first, second);
    }
    if (w.op == Op::square_root) return builder_.unary(w.op, use(a.packed_value, a.negated_lanes));
    Operand angle = use(a.packed_value, own(a));
    const bool odd = w.op == Op::sine && (angle.negative != ((own(a) ^ a.negated_lanes ^ sign) & 1U));
    angle.negative = false;
    Operand result = builder_.unary(w.op, angle);
    result.negative = odd;
    return result;
  }

  void compute_scalar(int s) {
    const LanePlan::Scalar& here = plan_.scalars[at(s)];
    Operand& made = scalars_[at(s)];
    if (here.packed_value >= 0) return;
    const Statement& old = p_.statements[at(s)];
    builder_.begin({}, s);
    if (!here.sum) {
      const Operand a = scalar(old.a);
      made = symbolic::is_binary(old.op) ? builder_.binary(old.op, a, scalar(old.b)) : builder_.unary(old.op, a);
    } else {
      std::vector<Operand> terms;
      for (const int packed_value : here.sum->packed_values)
        terms.push_back(builder_.sum_lanes(use(packed_value, 0), plan_.packed_values[at(packed_value)].width));
      for (const Operand& o : here.sum->rest) terms.push_back(scalar(o));
      made = builder_.sum(std::move(terms));
    }
    builder_.name(made, {{Operand::Kind::statement, s, false}});
  }
};

}  // namespace

Program lane_program(
    const Program& program,
    const LanePlan& plan,
    const std::vector<unsigned>& signs,
    LaneBuilder& builder) {
  return pair_sums(LaneProgramBuilder(program, plan, signs, builder).run());
}

}  // namespace robcogen::pass
