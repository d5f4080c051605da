#include "pass/pack_lanes.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "pass/lane_builder.h"
#include "pass/lane_signs.h"
#include "pass/statements.h"
#include "symbolic/count.h"

namespace robcogen::pass {
namespace {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

constexpr int kMostLanes = 8;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

// A value of lanes, flipped in some of them.
struct Part {
  int wide = -1;
  unsigned flips = 0;
};

// A value of lanes that the new program computes.
struct Wide {
  enum class Kind { broadcast, numbers, gather, operation, sum };
  Kind kind = Kind::gather;
  Tuple lanes;  // what it stands for, without signs; empty: a sum that no limb has by itself
  int width = 0;
  int place = 0;  // after which statement of the old program it can be computed
  Op op = Op::add;
  std::vector<Part> parts;
  Sign sign;                     // of what is computed, against `lanes`
  std::optional<Operand> value;  // in the new program
};

// A scalar sum of which some terms come from all limbs of a class.
struct SumOfLimbs {
  std::vector<int> wides;
  std::vector<Operand> rest;
};

class Packing {
 public:
  Packing(const Program& p, const std::vector<InputTuples>& classes)
      : p_(p),
        classes_(classes),
        inner_(inner_sums(p)),
        alike_(p, classes, inner_),
        builder_(p),
        scalars_(p.statements.size()) {}

  // None where values would have to wait for each other.
  std::optional<Program> run() {
    for (const symbolic::OutputArray& array : p_.outputs) pack_outputs(array);
    expand_all();
    if (!order_values()) return std::nullopt;
    for (const int node : order_)
      if (node >= scalar_count())
        choose_sign(wides_[at(node - scalar_count())]);
      else
        choose_signs_of_sum(node);
    for (const int root : roots_) signs_.make_plain(wides_[at(root)].sign);
    for (const int node : order_) {
      if (node >= scalar_count())
        compute_wide(node - scalar_count());
      else
        compute_scalar(node);
    }
    std::vector<std::vector<Operand>> outputs;
    for (const symbolic::OutputArray& array : p_.outputs) {
      outputs.emplace_back();
      for (const Operand& o : array.values) outputs.back().push_back(scalar(o));
    }
    return builder_.program(outputs);
  }

 private:
  struct Scalar {
    bool needed = false;
    int wide = -1, lane = -1;  // where it is a lane of a value
    std::optional<SumOfLimbs> sum;
    std::optional<Operand> value;  // in the new program
  };

  const Program& p_;
  const std::vector<InputTuples>& classes_;
  std::vector<bool> inner_;
  Correspondence alike_;
  LaneBuilder builder_;
  Signs signs_{kMostLanes};
  std::vector<Scalar> scalars_;  // by statement
  std::vector<Wide> wides_;
  std::map<std::vector<std::pair<int, int>>, int> known_;  // by kinds and indices of the lanes
  std::map<std::pair<int, unsigned>, Operand> flipped_;
  std::vector<int> roots_;
  std::vector<int> pending_wides_, pending_scalars_;
  std::vector<int> order_;  // statements, then wides; operands before users

  int scalar_count() const { return static_cast<int>(scalars_.size()); }
  const Statement& statement(const Operand& o) const { return p_.statements[at(o.index)]; }

  // -------------------------------------------------------------------------------------------------------------------
  // What is to be computed

  // The elements of each limb, each value once.
  void pack_outputs(const symbolic::OutputArray& array) {
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      std::vector<std::vector<Operand>> lists(width(c));
      std::vector<bool> seen(scalars_.size(), false);
      for (Operand o : array.values) {
        const Correspondence::Owner owner = alike_.owner(o);
        if (!is_statement(o) || owner.limbs != static_cast<int>(c) || seen[at(o.index)]) continue;
        seen[at(o.index)] = true;
        o.negative = false;
        lists[at(owner.lane)].push_back(o);
      }
      for (const Tuple& tuple : alike_.match(lists)) roots_.push_back(part(tuple).wide);
    }
    for (const Operand& o : array.values) need(o);
  }

  std::size_t width(std::size_t c) const { return classes_[c].empty() ? 0 : classes_[c].front().size(); }

  void need(const Operand& o) {
    if (!is_statement(o) || scalars_[at(o.index)].needed) return;
    scalars_[at(o.index)].needed = true;
    pending_scalars_.push_back(o.index);
  }

  Part part(Tuple tuple) {
    Part result;
    std::vector<std::pair<int, int>> key;
    for (std::size_t lane = 0; lane < tuple.size(); ++lane) {
      if (tuple[lane].negative) result.flips |= 1U << lane;
      tuple[lane].negative = false;
      key.emplace_back(static_cast<int>(tuple[lane].kind), tuple[lane].index);
    }
    const auto [place, fresh] = known_.try_emplace(std::move(key), static_cast<int>(wides_.size()));
    result.wide = place->second;
    if (fresh) add(std::move(tuple));
    return result;
  }

  void add(Tuple tuple) {
    Wide w;
    w.kind = kind_of(tuple);
    w.width = static_cast<int>(tuple.size());
    for (const Operand& o : tuple)
      if (is_statement(o)) w.place = std::max(w.place, o.index);
    w.lanes = std::move(tuple);
    pending_wides_.push_back(static_cast<int>(wides_.size()));
    wides_.push_back(std::move(w));
  }

  Wide::Kind kind_of(const Tuple& tuple) const {
    const auto all = [&](auto condition) { return std::all_of(tuple.begin(), tuple.end(), condition); };
    const Operand& first = tuple.front();
    if (all([](const Operand& o) { return o.kind == Operand::Kind::constant; })) return Wide::Kind::numbers;
    if (all([&](const Operand& o) { return o == first; })) return Wide::Kind::broadcast;
    if (!all(symbolic::is_statement)) return Wide::Kind::gather;
    const Op op = statement(first).op;
    if (is_sum(op) && all([&](const Operand& o) { return is_sum(statement(o).op); })) return Wide::Kind::sum;
    if (all([&](const Operand& o) { return statement(o).op == op; })) return Wide::Kind::operation;
    return Wide::Kind::gather;
  }

  // Vectors first: scalars that turn out to be lanes of them are not computed by themselves.
  void expand_all() {
    while (!pending_wides_.empty() || !pending_scalars_.empty()) {
      if (!pending_wides_.empty()) {
        const int wide = pending_wides_.back();
        pending_wides_.pop_back();
        expand_wide(at(wide));
        continue;
      }
      const int s = pending_scalars_.back();
      pending_scalars_.pop_back();
      if (scalars_[at(s)].wide < 0) expand_scalar(s);
    }
  }

  void expand_wide(std::size_t w) {
    const Wide::Kind kind = wides_[w].kind;
    const Tuple lanes = wides_[w].lanes;
    if (kind == Wide::Kind::broadcast || kind == Wide::Kind::gather)
      for (const Operand& o : lanes) need(o);
    if (kind != Wide::Kind::operation && kind != Wide::Kind::sum) return;
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
      Scalar& scalar = scalars_[at(lanes[lane].index)];
      if (scalar.wide >= 0) continue;
      scalar.wide = static_cast<int>(w);
      scalar.lane = static_cast<int>(lane);
    }
    const Op op = statement(lanes.front()).op;
    std::vector<Part> parts;
    if (kind == Wide::Kind::sum) {
      std::vector<std::vector<Operand>> lists;
      for (const Operand& o : lanes) lists.push_back(terms_of(p_, inner_, o.index));
      for (const Tuple& tuple : alike_.match(lists)) parts.push_back(part(tuple));
      for (const Tuple& tuple : filled_up(lists)) parts.push_back(part(tuple));
    } else if (op == Op::multiply) {
      std::vector<std::vector<Operand>> lists;
      for (const Operand& o : lanes) lists.push_back({statement(o).a, statement(o).b});
      for (const Tuple& tuple : alike_.match(lists)) parts.push_back(part(tuple));
      for (const Tuple& tuple : filled_up(lists)) parts.push_back(part(tuple));
    } else {
      Tuple a, b;
      for (const Operand& o : lanes) {
        a.push_back(statement(o).a);
        b.push_back(statement(o).b);
      }
      parts.push_back(part(a));
      if (symbolic::is_binary(op)) parts.push_back(part(b));
    }
    wides_[w].op = op;
    wides_[w].parts = std::move(parts);
  }

  // What is left, in its order; limbs that have fewer terms get zeros.
  std::vector<Tuple> filled_up(const std::vector<std::vector<Operand>>& lists) {
    std::size_t longest = 0;
    for (const std::vector<Operand>& list : lists) longest = std::max(longest, list.size());
    std::vector<Tuple> tuples(longest);
    for (std::size_t k = 0; k < longest; ++k)
      for (const std::vector<Operand>& list : lists)
        tuples[k].push_back(k < list.size() ? list[k] : builder_.number(Number()));
    return tuples;
  }

  void expand_scalar(int s) {
    const Statement& old = p_.statements[at(s)];
    if (is_sum(old.op)) find_sum_of_limbs(s);
    if (const std::optional<SumOfLimbs>& sum = scalars_[at(s)].sum) {
      for (const Operand& o : sum->rest) need(o);
      return;
    }
    need(old.a);
    if (symbolic::is_binary(old.op)) need(old.b);
  }

  void find_sum_of_limbs(int s) {
    if (alike_.owner({Operand::Kind::statement, s, false}).limbs >= 0) return;
    SumOfLimbs sum;
    std::vector<std::vector<std::vector<Operand>>> lists;
    for (std::size_t c = 0; c < classes_.size(); ++c) lists.emplace_back(width(c));
    for (const Operand& o : terms_of(p_, inner_, s)) {
      const Correspondence::Owner owner = alike_.owner(o);
      (owner.limbs < 0 || !is_statement(o) ? sum.rest : lists[at(owner.limbs)][at(owner.lane)]).push_back(o);
    }
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      Wide w;
      w.kind = Wide::Kind::sum;
      w.width = static_cast<int>(width(c));
      w.place = s;
      for (const Tuple& tuple : alike_.match(lists[c])) w.parts.push_back(part(tuple));
      for (const std::vector<Operand>& list : lists[c]) sum.rest.insert(sum.rest.end(), list.begin(), list.end());
      if (w.parts.empty()) continue;
      sum.wides.push_back(static_cast<int>(wides_.size()));
      wides_.push_back(std::move(w));
    }
    if (!sum.wides.empty()) scalars_[at(s)].sum = std::move(sum);
  }

  // -------------------------------------------------------------------------------------------------------------------
  // In which order

  std::vector<int> read_by(int node) const {
    std::vector<int> nodes;
    const auto note = [&](const Operand& o) {
      if (is_statement(o)) nodes.push_back(o.index);
    };
    if (node >= scalar_count()) {
      const Wide& w = wides_[at(node - scalar_count())];
      for (const Part& part : w.parts) nodes.push_back(scalar_count() + part.wide);
      if (w.kind == Wide::Kind::broadcast || w.kind == Wide::Kind::gather)
        for (const Operand& o : w.lanes) note(o);
      return nodes;
    }
    const Scalar& s = scalars_[at(node)];
    if (s.wide >= 0) return {scalar_count() + s.wide};
    if (s.sum) {
      for (const int wide : s.sum->wides) nodes.push_back(scalar_count() + wide);
      for (const Operand& o : s.sum->rest) note(o);
      return nodes;
    }
    for_each_read(p_.statements[at(node)], [&](int read) { nodes.push_back(read); });
    return nodes;
  }

  bool order_values() {
    enum class State { fresh, open, done };
    std::vector<State> states(scalars_.size() + wides_.size(), State::fresh);
    std::vector<int> pending;
    for (const symbolic::OutputArray& array : p_.outputs) {
      for (auto o = array.values.rbegin(); o != array.values.rend(); ++o)
        if (is_statement(*o)) pending.push_back(o->index);
    }
    while (!pending.empty()) {
      const int node = pending.back();
      State& state = states[at(node)];
      if (state != State::fresh) {
        pending.pop_back();
        if (state == State::open) order_.push_back(node);
        state = State::done;
        continue;
      }
      state = State::open;
      for (const int read : read_by(node)) {
        if (states[at(read)] == State::open) return false;
        if (states[at(read)] == State::fresh) pending.push_back(read);
      }
    }
    return true;
  }

  // -------------------------------------------------------------------------------------------------------------------
  // With which signs

  Sign sign_of(const Part& part) const { return signs_.product(wides_[at(part.wide)].sign, signs_.fixed(part.flips)); }
  bool is_numbers(const Part& part) const { return wides_[at(part.wide)].kind == Wide::Kind::numbers; }

  void choose_sign(Wide& w) {
    switch (w.kind) {
      case Wide::Kind::numbers:
        return;
      case Wide::Kind::broadcast:
      case Wide::Kind::gather:
        w.sign = signs_.variable(true);
        return;
      case Wide::Kind::sum:
        agree(w.parts);
        for (const Part& part : w.parts)
          if (!is_numbers(part)) {
            w.sign = sign_of(part);
            break;
          }
        return;
      case Wide::Kind::operation:
        break;
    }
    if (w.op == Op::multiply || w.op == Op::divide) {
      const bool takes_signs = is_numbers(w.parts[0]) || is_numbers(w.parts[1]);
      w.sign = takes_signs ? signs_.variable(false) : signs_.product(sign_of(w.parts[0]), sign_of(w.parts[1]));
    } else if (w.op == Op::sine) {
      w.sign = sign_of(w.parts[0]);
    } else if (w.op == Op::square_root) {
      signs_.make_plain(sign_of(w.parts[0]));
    }
  }

  // Makes the signs of the terms of a sum the same, as far as that is free.
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
    if (scalars_[at(s)].wide >= 0 || !scalars_[at(s)].sum) return;
    for (const int wide : scalars_[at(s)].sum->wides) signs_.make_plain(wides_[at(wide)].sign);
  }

  // -------------------------------------------------------------------------------------------------------------------
  // The new program

  unsigned all(const Wide& w) const { return (1U << w.width) - 1U; }
  unsigned value(const Wide& w) const { return signs_.value(w.sign) & all(w); }

  // The value of a scalar operand of the old program.
  Operand scalar(const Operand& o) {
    if (!is_statement(o)) return o;
    const Scalar& s = scalars_[at(o.index)];
    Operand result = s.wide < 0 ? *s.value : lane(s.wide, s.lane);
    result.negative = result.negative != o.negative;
    return result;
  }

  Operand lane(int wide, int lane) {
    const Wide& w = wides_[at(wide)];
    Operand result = *w.value;
    if (builder_.width(result) > 1) result.lane = lane;
    if (value(w) >> lane & 1U) result.negative = !result.negative;
    return result;
  }

  // A value of lanes whose lanes are negated like this.
  Operand use(int wide, unsigned flips) {
    const Wide& w = wides_[at(wide)];
    if (w.kind == Wide::Kind::numbers) return builder_.numbers(w.lanes, flips & all(w));
    const bool is_leaf = w.kind == Wide::Kind::broadcast || w.kind == Wide::Kind::gather;
    unsigned change = (flips ^ (is_leaf ? 0U : value(w))) & all(w);
    const bool negative = change & 1U;
    if (negative) change ^= all(w);
    Operand result = *w.value;
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

  void compute_wide(int wide) {
    Wide& w = wides_[at(wide)];
    builder_.begin(w.lanes, w.place);
    switch (w.kind) {
      case Wide::Kind::numbers:
        w.value = Operand();  // made where it is used
        return;
      case Wide::Kind::broadcast:
        w.value = scalar(w.lanes.front());
        return;
      case Wide::Kind::gather: {
        Tuple lanes;
        for (const Operand& o : w.lanes) lanes.push_back(scalar(o));
        w.value = builder_.gather(std::move(lanes));
        return;
      }
      case Wide::Kind::sum: {
        std::vector<Operand> terms;
        for (const Part& part : w.parts) terms.push_back(use(part.wide, value(w) ^ part.flips));
        w.value = builder_.sum(std::move(terms));
        break;
      }
      case Wide::Kind::operation:
        w.value = operation(w);
        break;
    }
    if (!w.lanes.empty()) builder_.name(*w.value, w.lanes);
  }

  Operand operation(const Wide& w) {
    const Part a = w.parts[0];
    const auto own = [&](const Part& part) { return value(wides_[at(part.wide)]); };
    if (symbolic::is_binary(w.op)) {
      const Part b = w.parts[1];
      const unsigned both = value(w) ^ a.flips ^ b.flips;
      const unsigned of_a = is_numbers(a) ? both ^ own(b) : own(a);
      const Operand first = use(a.wide, of_a), second = use(b.wide, both ^ of_a);
      return w.op == Op::multiply ? builder_.product(first, second) : builder_.quotient(first, second);
    }
    if (w.op == Op::square_root) return builder_.unary(w.op, use(a.wide, a.flips));
    Operand angle = use(a.wide, own(a));
    const bool odd = w.op == Op::sine && (angle.negative != ((own(a) ^ a.flips ^ value(w)) & 1U));
    angle.negative = false;
    Operand result = builder_.unary(w.op, angle);
    result.negative = odd;
    return result;
  }

  void compute_scalar(int s) {
    Scalar& here = scalars_[at(s)];
    if (here.wide >= 0) return;
    const Statement& old = p_.statements[at(s)];
    builder_.begin({}, s);
    if (!here.sum) {
      const Operand a = scalar(old.a);
      here.value = symbolic::is_binary(old.op) ? builder_.binary(old.op, a, scalar(old.b)) : builder_.unary(old.op, a);
    } else {
      std::vector<Operand> terms;
      for (const int wide : here.sum->wides) terms.push_back(builder_.sum_lanes(use(wide, 0), wides_[at(wide)].width));
      for (const Operand& o : here.sum->rest) terms.push_back(scalar(o));
      here.value = builder_.sum(std::move(terms));
    }
    builder_.name(*here.value, {{Operand::Kind::statement, s, false}});
  }
};

// What is predicted to gain less may lose.
bool is_clearly_faster(int time, int other) {
  return 8 * time < 7 * other;
}

bool can_be_lanes(const InputTuples& limbs) {
  const std::size_t width = limbs.empty() ? 0 : limbs.front().size();
  return width == 2 || width == 4 || width == kMostLanes;
}

}  // namespace

Program packed(const Program& program, const std::vector<InputTuples>& classes) {
  std::vector<InputTuples> with_inputs;
  std::copy_if(classes.begin(), classes.end(), std::back_inserter(with_inputs), can_be_lanes);
  return Packing(program, with_inputs).run().value_or(program);
}

Program with_plain_numbers(const Program& program) {
  Program result = program;
  result.constants.clear();
  std::vector<int> place;
  for (const Number& n : program.constants) {
    const Number number = n.plain();
    const auto known = std::find(result.constants.begin(), result.constants.end(), number);
    place.push_back(static_cast<int>(known - result.constants.begin()));
    if (known == result.constants.end()) result.constants.push_back(number);
  }
  const auto renumber = [&](Operand& o) {
    if (o.kind == Operand::Kind::constant) o.index = place[at(o.index)];
  };
  for (Statement& s : result.statements) for_each_operand(s, renumber);
  for (symbolic::OutputArray& array : result.outputs) std::for_each(array.values.begin(), array.values.end(), renumber);
  return result;
}

namespace {

Packed pack_classes(const Program& program, const std::vector<InputTuples>& classes) {
  Packed best = {program, std::vector<bool>(classes.size(), false)};
  std::vector<InputTuples> chosen;
  int time = symbolic::predicted_time(program);
  for (std::size_t c = 0; c < classes.size(); ++c) {
    if (!can_be_lanes(classes[c])) continue;
    chosen.push_back(classes[c]);
    std::optional<Program> candidate = Packing(program, chosen).run();
    const int candidate_time = candidate ? symbolic::predicted_time(*candidate) : time;
    if (is_clearly_faster(candidate_time, time)) {
      time = candidate_time;
      best.program = std::move(*candidate);
      best.in_lanes[c] = true;
    } else {
      chosen.pop_back();
    }
  }
  return best;
}

}  // namespace

Packed pack_lanes(
    const Program& program,
    const std::vector<InputTuples>& classes,
    const std::optional<Program>& alike) {
  Packed best = pack_classes(program, classes);
  if (!alike) return best;
  Packed other = pack_classes(with_plain_numbers(*alike), classes);
  const int time = symbolic::predicted_time(other.program);
  const bool is_best = time < symbolic::predicted_time(best.program);
  return is_best && is_clearly_faster(time, symbolic::predicted_time(program)) ? other : best;
}

}  // namespace robcogen::pass
