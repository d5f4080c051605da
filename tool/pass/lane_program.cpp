#include "pass/lane_program.h"

#include <map>

#include "pass/lane_builder.h"
#include "pass/pair_sums.h"
#include "support/index.h"

namespace robcogen::pass {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

class Making {
 public:
  Making(const Program& p, const LanePlan& plan, const std::vector<unsigned>& signs, LaneBuilder& builder)
      : p_(p),
        plan_(plan),
        signs_(signs),
        builder_(builder),
        scalars_(plan.scalars.size()),
        wides_(plan.wides.size()) {}

  Program run() {
    for (const int node : plan_.order)
      if (node >= plan_.scalar_count())
        compute_wide(at(node - plan_.scalar_count()));
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
  // A value, of which some lanes are negated.
  struct Lanes {
    Operand value;
    unsigned negated = 0;
  };

  const Program& p_;
  const LanePlan& plan_;
  const std::vector<unsigned>& signs_;  // by wide: the lanes that are kept negated
  LaneBuilder& builder_;
  std::vector<Operand> scalars_, wides_;  // what was made
  std::map<std::pair<int, unsigned>, Operand> flipped_;
  std::map<int, Lanes> roots_;  // by wide: what outputs take in its place

  const Wide& wide(const Part& part) const { return plan_.wides[at(part.wide)]; }
  bool is_numbers(const Part& part) const { return wide(part).kind == Wide::Kind::numbers; }

  // The value of a scalar operand of the old program.
  Operand scalar(const Operand& o) {
    if (!is_statement(o)) return o;
    const LanePlan::Scalar& s = plan_.scalars[at(o.index)];
    Operand result = s.wide < 0 ? scalars_[at(o.index)] : lane({wides_[at(s.wide)], signs_[at(s.wide)]}, s.lane);
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
    const auto root = roots_.find(s.wide);
    if (root == roots_.end()) return scalar(o);
    Operand result = lane(root->second, s.lane);
    result.negative = result.negative != o.negative;
    return result;
  }

  // Where lanes are kept with other signs than outputs give them, all of them are changed at once: less than one by
  // one, and what has the same sign in all lanes can be stored as a vector.
  void make_root(const Part& root) {
    const Wide& w = plan_.wides[at(root.wide)];
    const unsigned change = (signs_[at(root.wide)] ^ root.flips) & all_lanes(w);
    const bool is_operation = w.kind == Wide::Kind::operation || w.kind == Wide::Kind::sum;
    if (!is_operation || change == 0 || change == all_lanes(w)) return;
    builder_.begin(w.lanes, w.place);
    const unsigned negated = root.flips & all_lanes(w);
    roots_.emplace(root.wide, Lanes{use(root.wide, negated), negated});
  }

  // A value of lanes whose lanes are negated like this.
  Operand use(int wide, unsigned flips) {
    const Wide& w = plan_.wides[at(wide)];
    if (w.kind == Wide::Kind::numbers) return builder_.numbers(w.lanes, flips & all_lanes(w));
    const bool is_leaf = w.kind == Wide::Kind::broadcast || w.kind == Wide::Kind::gather;
    unsigned change = (flips ^ (is_leaf ? 0U : signs_[at(wide)])) & all_lanes(w);
    const bool negative = change & 1U;
    if (negative) change ^= all_lanes(w);
    Operand result = wides_[at(wide)];
    if (change) {
      const auto known = flipped_.find({wide, change});
      if (known != flipped_.end()) {
        result = known->second;
      } else {
        const Tuple ones(at(w.width), builder_.number(Number(1.0)));
        result = builder_.product(result, builder_.numbers(ones, change));
        flipped_.emplace(std::pair(wide, change), result);
      }
    }
    result.negative = result.negative != negative;
    return result;
  }

  void compute_wide(std::size_t index) {
    const Wide& w = plan_.wides[index];
    Operand& made = wides_[index];
    builder_.begin(w.lanes, w.place);
    switch (w.kind) {
      case Wide::Kind::numbers:
        return;  // made where they are used
      case Wide::Kind::broadcast:
        made = scalar(w.lanes.front());
        return;
      case Wide::Kind::gather: {
        Tuple lanes;
        for (const Operand& o : w.lanes) lanes.push_back(scalar(o));
        made = builder_.gather(std::move(lanes));
        return;
      }
      case Wide::Kind::sum: {
        std::vector<Operand> terms;
        for (const Part& part : w.parts) terms.push_back(use(part.wide, signs_[index] ^ part.flips));
        made = builder_.sum(std::move(terms));
        break;
      }
      case Wide::Kind::operation:
        made = operation(w, signs_[index]);
        break;
    }
    if (!w.lanes.empty()) builder_.name(made, w.lanes);
  }

  Operand operation(const Wide& w, unsigned sign) {
    const Part a = w.parts[0];
    const auto own = [&](const Part& part) { return signs_[at(part.wide)]; };
    if (symbolic::is_binary(w.op)) {
      const Part b = w.parts[1];
      const unsigned both = sign ^ a.flips ^ b.flips;
      const unsigned of_a = is_numbers(a) ? both ^ own(b) : own(a);
      const Operand first = use(a.wide, of_a), second = use(b.wide, both ^ of_a);
      return w.op == Op::multiply ? builder_.product(first, second) : builder_.quotient(first, second);
    }
    if (w.op == Op::square_root) return builder_.unary(w.op, use(a.wide, a.flips));
    Operand angle = use(a.wide, own(a));
    const bool odd = w.op == Op::sine && (angle.negative != ((own(a) ^ a.flips ^ sign) & 1U));
    angle.negative = false;
    Operand result = builder_.unary(w.op, angle);
    result.negative = odd;
    return result;
  }

  void compute_scalar(int s) {
    const LanePlan::Scalar& here = plan_.scalars[at(s)];
    Operand& made = scalars_[at(s)];
    if (here.wide >= 0) return;
    const Statement& old = p_.statements[at(s)];
    builder_.begin({}, s);
    if (!here.sum) {
      const Operand a = scalar(old.a);
      made = symbolic::is_binary(old.op) ? builder_.binary(old.op, a, scalar(old.b)) : builder_.unary(old.op, a);
    } else {
      std::vector<Operand> terms;
      for (const int wide : here.sum->wides)
        terms.push_back(builder_.sum_lanes(use(wide, 0), plan_.wides[at(wide)].width));
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
  return pair_sums(Making(program, plan, signs, builder).run());
}

}  // namespace robcogen::pass
