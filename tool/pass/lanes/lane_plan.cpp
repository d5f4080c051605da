#include "pass/lanes/lane_plan.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "pass/statements.h"
#include "support/index.h"

namespace robcogen::pass {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

// The kind and index of each lane as one number; 0: no such lane.
using LaneKey = std::array<std::uint64_t, at(kMaxLanes)>;

struct HashOfLanes {
  std::size_t operator()(const LaneKey& key) const {
    std::uint64_t hash = 0;
    for (const std::uint64_t lane : key) hash = (hash ^ lane) * 0x9e3779b97f4a7c15ULL, hash ^= hash >> 32;
    return static_cast<std::size_t>(hash);
  }
};

// So many packed values are never too many.
constexpr std::size_t kFew = 100;

// Chooses the values that are packed.
class LanePacker {
 public:
  LanePacker(const Program& p, const std::vector<InputTuples>& classes, const Operand& zero)
      : p_(p),
        classes_(classes),
        zero_(zero),
        inner_(inner_sums(p, use_counts(p))),
        correspondence_(p, classes, inner_) {
    plan_.scalars.resize(p.statements.size());
  }

  // nullopt if there are many more packed values than statements: the limbs are too different for a gain, and their
  // values would be packed in more and more combinations.
  std::optional<LanePlan> run() {
    for (const symbolic::OutputArray& array : p_.outputs) pack_outputs(array);
    pack_across_outputs();
    if (!expand_all()) return std::nullopt;
    return std::move(plan_);
  }

 private:
  const Program& p_;
  const std::vector<InputTuples>& classes_;
  Operand zero_;
  std::vector<bool> inner_;
  Correspondence correspondence_;
  LanePlan plan_;
  std::unordered_map<LaneKey, int, HashOfLanes> known_;
  std::vector<int> pending_packed_, pending_scalars_;
  std::vector<std::vector<Operand>> lists_;  // of expand_packed: allocated once for all packed values

  const Statement& statement(const Operand& o) const { return p_.statements[at(o.index)]; }

  // What is left of arrays of one shape, by class and lane, and how many arrays these were.
  struct Rest {
    int rows, columns;
    symbolic::Role role;
    std::vector<std::vector<std::vector<Operand>>> lists;
    int arrays = 0;
  };
  std::vector<Rest> rests_;

  Rest& rest_like(const symbolic::OutputArray& array) {
    for (Rest& rest : rests_)
      if (rest.rows == array.rows && rest.columns == array.columns && rest.role == array.role) return rest;
    Rest& rest = rests_.emplace_back(Rest{array.rows, array.columns, array.role, {}});
    for (std::size_t c = 0; c < classes_.size(); ++c) rest.lists.emplace_back(width(c));
    return rest;
  }

  // Packs the output elements of the limbs, each value once.
  void pack_outputs(const symbolic::OutputArray& array) {
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      std::vector<std::vector<Operand>> lists(width(c));
      std::vector<bool> seen(plan_.scalars.size(), false);
      for (const Operand& o : array.values) {
        const Correspondence::Owner owner = correspondence_.owner(o);
        if (!is_statement(o) || owner.limbs != static_cast<int>(c) || seen[at(o.index)]) continue;
        seen[at(o.index)] = true;
        lists[at(owner.lane)].push_back(o);
      }
      for (const Tuple& tuple : correspondence_.match(lists)) plan_.roots.push_back(part(tuple));
      for (std::size_t lane = 0; lane < lists.size(); ++lane) {
        std::vector<Operand>& rest = rest_like(array).lists[c][lane];
        rest.insert(rest.end(), lists[lane].begin(), lists[lane].end());
      }
    }
    ++rest_like(array).arrays;
    for (const Operand& o : array.values) need(o);
  }

  // Each limb may have an array of its own: the Jacobian of its foot.
  void pack_across_outputs() {
    for (Rest& rest : rests_)
      for (std::size_t c = 0; rest.arrays > 1 && c < classes_.size(); ++c)
        for (const Tuple& tuple : correspondence_.match(rest.lists[c])) plan_.roots.push_back(part(tuple));
  }

  std::size_t width(std::size_t c) const { return classes_[c].empty() ? 0 : classes_[c].front().size(); }

  void need(const Operand& o) {
    if (!is_statement(o) || plan_.scalars[at(o.index)].needed) return;
    plan_.scalars[at(o.index)].needed = true;
    pending_scalars_.push_back(o.index);
  }

  Part part(Tuple tuple) {
    Part result;
    LaneKey key = {};
    for (std::size_t lane = 0; lane < tuple.size(); ++lane) {
      if (tuple[lane].negative) result.negated_lanes |= 1U << lane;
      tuple[lane].negative = false;
      const auto kind = static_cast<std::uint64_t>(tuple[lane].kind);
      key[lane] = (kind + 1) << 32 | static_cast<std::uint64_t>(tuple[lane].index);
    }
    const auto [place, fresh] = known_.try_emplace(key, static_cast<int>(plan_.packed_values.size()));
    result.packed_value = place->second;
    if (fresh) add(std::move(tuple));
    return result;
  }

  void add(Tuple tuple) {
    PackedValue w;
    w.kind = kind_of(tuple);
    w.width = static_cast<int>(tuple.size());
    for (const Operand& o : tuple)
      if (is_statement(o)) w.place = std::max(w.place, o.index);
    w.lanes = std::move(tuple);
    pending_packed_.push_back(static_cast<int>(plan_.packed_values.size()));
    plan_.packed_values.push_back(std::move(w));
  }

  PackedValue::Kind kind_of(const Tuple& tuple) const {
    const auto all = [&](auto condition) { return std::all_of(tuple.begin(), tuple.end(), condition); };
    const Operand& first = tuple.front();
    if (all(symbolic::is_constant)) return PackedValue::Kind::numbers;
    if (all([&](const Operand& o) { return o == first; })) return PackedValue::Kind::broadcast;
    if (!all(symbolic::is_statement)) return PackedValue::Kind::gather;
    const Op op = statement(first).op;
    if (is_sum(op) && all([&](const Operand& o) { return is_sum(statement(o).op); })) return PackedValue::Kind::sum;
    if (all([&](const Operand& o) { return statement(o).op == op; })) return PackedValue::Kind::operation;
    return PackedValue::Kind::gather;
  }

  // Expands packed values first, because scalars that turn out to be lanes of them need not be computed separately.
  // False if there are too many.
  bool expand_all() {
    while (!pending_packed_.empty() || !pending_scalars_.empty()) {
      if (plan_.packed_values.size() > p_.statements.size() + kFew) return false;
      if (!pending_packed_.empty()) {
        const int packed_value = pending_packed_.back();
        pending_packed_.pop_back();
        expand_packed(at(packed_value));
        continue;
      }
      const int s = pending_scalars_.back();
      pending_scalars_.pop_back();
      if (plan_.scalars[at(s)].packed_value < 0) expand_scalar(s);
    }
    return true;
  }

  void expand_packed(std::size_t w) {
    const PackedValue::Kind kind = plan_.packed_values[w].kind;
    const Tuple lanes = plan_.packed_values[w].lanes;
    if (kind == PackedValue::Kind::broadcast || kind == PackedValue::Kind::gather)
      for (const Operand& o : lanes) need(o);
    if (kind != PackedValue::Kind::operation && kind != PackedValue::Kind::sum) return;
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
      LanePlan::Scalar& scalar = plan_.scalars[at(lanes[lane].index)];
      if (scalar.packed_value >= 0) continue;
      scalar.packed_value = static_cast<int>(w);
      scalar.lane = static_cast<int>(lane);
    }
    const Op op = statement(lanes.front()).op;
    std::vector<Part> parts;
    if (kind == PackedValue::Kind::sum) {
      lists_.resize(lanes.size());
      for (std::size_t lane = 0; lane < lanes.size(); ++lane) terms_of(p_, inner_, lanes[lane].index, lists_[lane]);
      parts = parts_of(lists_);
    } else if (op == Op::multiply) {
      lists_.resize(lanes.size());
      for (std::size_t lane = 0; lane < lanes.size(); ++lane)
        lists_[lane] = {statement(lanes[lane]).a, statement(lanes[lane]).b};
      parts = parts_of(lists_);
    } else {
      Tuple a, b;
      for (const Operand& o : lanes) {
        a.push_back(statement(o).a);
        b.push_back(statement(o).b);
      }
      parts.push_back(part(std::move(a)));
      if (symbolic::is_binary(op)) parts.push_back(part(std::move(b)));
    }
    plan_.packed_values[w].op = op;
    plan_.packed_values[w].parts = std::move(parts);
  }

  // Packs the terms or factors of the limbs: first those that correspond, then the rest.
  std::vector<Part> parts_of(std::vector<std::vector<Operand>>& lists) {
    std::vector<Part> parts;
    for (Tuple& tuple : correspondence_.match(lists)) parts.push_back(part(std::move(tuple)));
    for (Tuple& tuple : filled_up(lists)) parts.push_back(part(std::move(tuple)));
    return parts;
  }

  // The remaining operands in the given order; limbs with fewer operands get zeros.
  std::vector<Tuple> filled_up(const std::vector<std::vector<Operand>>& lists) {
    std::size_t longest = 0;
    for (const std::vector<Operand>& list : lists) longest = std::max(longest, list.size());
    std::vector<Tuple> tuples(longest);
    for (std::size_t k = 0; k < longest; ++k)
      for (const std::vector<Operand>& list : lists) tuples[k].push_back(k < list.size() ? list[k] : zero_);
    return tuples;
  }

  void expand_scalar(int s) {
    const Statement& old = p_.statements[at(s)];
    if (is_sum(old.op)) find_sum_of_limbs(s);
    if (const std::optional<SumOfLimbs>& sum = plan_.scalars[at(s)].sum) {
      for (const Operand& o : sum->rest) need(o);
      return;
    }
    for_each_operand(old, [&](const Operand& o) { need(o); });
  }

  void find_sum_of_limbs(int s) {
    if (correspondence_.owner({Operand::Kind::statement, s, false}).limbs >= 0) return;
    SumOfLimbs sum;
    std::vector<std::vector<std::vector<Operand>>> lists;
    for (std::size_t c = 0; c < classes_.size(); ++c) lists.emplace_back(width(c));
    std::vector<Operand> terms;
    terms_of(p_, inner_, s, terms);
    for (const Operand& o : terms) {
      const Correspondence::Owner owner = correspondence_.owner(o);
      (owner.limbs < 0 || !is_statement(o) ? sum.rest : lists[at(owner.limbs)][at(owner.lane)]).push_back(o);
    }
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      PackedValue w;
      w.kind = PackedValue::Kind::sum;
      w.width = static_cast<int>(width(c));
      w.place = s;
      for (const Tuple& tuple : correspondence_.match(lists[c])) w.parts.push_back(part(tuple));
      for (const std::vector<Operand>& list : lists[c]) sum.rest.insert(sum.rest.end(), list.begin(), list.end());
      if (w.parts.empty()) continue;
      sum.packed_values.push_back(static_cast<int>(plan_.packed_values.size()));
      plan_.packed_values.push_back(std::move(w));
    }
    if (!sum.packed_values.empty()) plan_.scalars[at(s)].sum = std::move(sum);
  }
};

// The nodes of the order that a node reads. The first nodes are scalars, the others packed values.
std::vector<int> read_by(const Program& program, const LanePlan& plan, int node) {
  std::vector<int> nodes;
  const auto note = [&](const Operand& o) {
    if (is_statement(o)) nodes.push_back(o.index);
  };
  if (node >= plan.scalar_count()) {
    const PackedValue& w = plan.packed_values[at(node - plan.scalar_count())];
    for (const Part& part : w.parts) nodes.push_back(plan.scalar_count() + part.packed_value);
    if (w.kind == PackedValue::Kind::broadcast || w.kind == PackedValue::Kind::gather)
      for (const Operand& o : w.lanes) note(o);
    return nodes;
  }
  const LanePlan::Scalar& s = plan.scalars[at(node)];
  if (s.packed_value >= 0) return {plan.scalar_count() + s.packed_value};
  if (s.sum) {
    for (const int packed_value : s.sum->packed_values) nodes.push_back(plan.scalar_count() + packed_value);
    for (const Operand& o : s.sum->rest) note(o);
    return nodes;
  }
  for_each_read(program.statements[at(node)], [&](int read) { nodes.push_back(read); });
  return nodes;
}

// Puts every value after those that it reads; false if two values depend on each other.
bool order_values(const Program& program, LanePlan& plan) {
  enum class State { fresh, open, done };
  std::vector<State> states(plan.scalars.size() + plan.packed_values.size(), State::fresh);
  std::vector<int> pending;
  for (const symbolic::OutputArray& array : program.outputs) {
    for (auto o = array.values.rbegin(); o != array.values.rend(); ++o)
      if (is_statement(*o)) pending.push_back(o->index);
  }
  while (!pending.empty()) {
    const int node = pending.back();
    State& state = states[at(node)];
    if (state != State::fresh) {
      pending.pop_back();
      if (state == State::open) plan.order.push_back(node);
      state = State::done;
      continue;
    }
    state = State::open;
    for (const int read : read_by(program, plan, node)) {
      if (states[at(read)] == State::open) return false;
      if (states[at(read)] == State::fresh) pending.push_back(read);
    }
  }
  return true;
}

}  // namespace

std::optional<LanePlan> lane_plan(
    const Program& program,
    const std::vector<InputTuples>& classes,
    const Operand& zero) {
  std::optional<LanePlan> plan = LanePacker(program, classes, zero).run();
  if (!plan || !order_values(program, *plan)) return std::nullopt;
  return plan;
}

}  // namespace robcogen::pass
