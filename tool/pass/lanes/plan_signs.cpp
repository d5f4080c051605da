#include "pass/lanes/plan_signs.h"

#include "pass/lanes/lane_signs.h"
#include "support/index.h"

namespace robcogen::pass {
namespace {

using symbolic::Op;

class SignChoice {
 public:
  explicit SignChoice(const LanePlan& plan) : plan_(plan), sign_(plan.packed_values.size()) {}

  std::vector<unsigned> run() {
    for (const int node : plan_.order)
      if (node >= plan_.scalar_count())
        choose_sign(at(node - plan_.scalar_count()));
      else
        choose_signs_of_sum(node);
    for (const Part& root : plan_.roots) signs_.make_plain(sign_of(root));
    std::vector<unsigned> values;
    for (std::size_t w = 0; w < sign_.size(); ++w)
      values.push_back(signs_.value(sign_[w]) & all_lanes(plan_.packed_values[w]));
    return values;
  }

 private:
  const LanePlan& plan_;
  Signs signs_{kMaxLanes};
  std::vector<Sign> sign_;  // by packed value: sign of the computed value relative to the one that it stands for

  const PackedValue& packed_value(const Part& part) const { return plan_.packed_values[at(part.packed_value)]; }
  Sign sign_of(const Part& part) const {
    return signs_.product(sign_[at(part.packed_value)], signs_.fixed(part.negated_lanes));
  }
  bool is_numbers(const Part& part) const { return packed_value(part).kind == PackedValue::Kind::numbers; }

  void choose_sign(std::size_t index) {
    const PackedValue& w = plan_.packed_values[index];
    Sign& sign = sign_[index];
    switch (w.kind) {
      case PackedValue::Kind::numbers:
        return;
      case PackedValue::Kind::broadcast:
      case PackedValue::Kind::gather:
        sign = signs_.variable(true);
        return;
      case PackedValue::Kind::sum:
        agree(w.parts);
        for (const Part& part : w.parts)
          if (!is_numbers(part)) {
            sign = sign_of(part);
            break;
          }
        return;
      case PackedValue::Kind::operation:
        break;
    }
    if (w.op == Op::multiply || w.op == Op::divide) {
      const bool takes_signs = is_numbers(w.parts[0]) || is_numbers(w.parts[1]);
      sign = takes_signs ? signs_.variable(false) : signs_.product(sign_of(w.parts[0]), sign_of(w.parts[1]));
    } else if (w.op == Op::sine) {
      sign = sign_of(w.parts[0]);
    } else if (w.op == Op::square_root) {
      signs_.make_plain(sign_of(w.parts[0]));
    }
  }

  // Makes the signs of the terms of a sum equal, as far as that costs nothing.
  void agree(const std::vector<Part>& parts) {
    const Part* first = nullptr;
    for (const Part& part : parts) {
      if (is_numbers(part)) continue;
      if (first)
        signs_.make_plain(signs_.product(sign_of(*first), sign_of(part)));
      else
        first = &part;
    }
  }

  void choose_signs_of_sum(int s) {
    const LanePlan::Scalar& scalar = plan_.scalars[at(s)];
    if (scalar.packed_value >= 0 || !scalar.sum) return;
    for (const int packed_value : scalar.sum->packed_values) signs_.make_plain(sign_[at(packed_value)]);
  }
};

}  // namespace

std::vector<unsigned> plan_signs(const LanePlan& plan) {
  return SignChoice(plan).run();
}

}  // namespace robcogen::pass
