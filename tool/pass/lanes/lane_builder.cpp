#include "pass/lanes/lane_builder.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <utility>

#include "pass/statements.h"
#include "support/index.h"
#include "symbolic/cost.h"
#include "symbolic/lane_names.h"
#include "symbolic/quantity.h"

namespace robcogen::pass {

using symbolic::Constant;
using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

LaneBuilder::LaneBuilder(const Program& old)
    : old_(old), new_{old.name, old.inputs, old.outputs, old.constants, {}, {}} {}

void LaneBuilder::begin(const Tuple& lanes, int place) {
  place_ = place;
  section_ = section_of(lanes, place);
}

int LaneBuilder::section_of(const Tuple& lanes, int place) {
  std::vector<int> key;
  for (const Operand& o : lanes)
    if (is_statement(o)) key.push_back(old_.statements[at(o.index)].section);
  if (key.empty()) {
    if (old_.statements.empty()) return 0;
    key = {old_.statements[at(place)].section};
  }
  const auto [known, fresh] = sections_.try_emplace(key, static_cast<int>(new_.sections.size()));
  if (!fresh) return known->second;
  std::vector<std::string> titles, prefixes;
  for (const int section : key) {
    titles.push_back(old_.sections[at(section)].title);
    prefixes.push_back(old_.sections[at(section)].prefix);
  }
  new_.sections.push_back({symbolic::common_title(titles), symbolic::common_name(prefixes)});
  return known->second;
}

int LaneBuilder::width(const Operand& o) const {
  return is_statement(o) && o.lane < 0 ? scheduled_[at(o.index)].statement.width : 1;
}

Operand LaneBuilder::constant(const Constant& value) {
  const auto known = std::find_if(new_.constants.begin(), new_.constants.end(), [&](const Constant& c) {
    return c.value() == value.value() && c.number().is_pi_multiple() == value.number().is_pi_multiple();
  });
  const auto index = static_cast<int>(known - new_.constants.begin());
  if (known == new_.constants.end()) new_.constants.push_back(value);
  return {Operand::Kind::constant, index, false};
}

Operand LaneBuilder::append(Statement s, int latency) {
  s.section = section_;
  s.width = s.op == Op::gather      ? static_cast<int>(s.lanes.size())
            : s.op == Op::sum_lanes ? 1
                                    : std::max(width(s.a), symbolic::is_binary(s.op) ? width(s.b) : 1);
  int start = 0;
  for_each_operand(s, [&](const Operand& o) { start = std::max(start, ready(o)); });
  Scheduled scheduled = {std::move(s), place_, false, start + latency};
  scheduled_.push_back(std::move(scheduled));
  return {Operand::Kind::statement, static_cast<int>(scheduled_.size()) - 1, false};
}

int LaneBuilder::ready(const Operand& o) const {
  return is_statement(o) ? scheduled_[at(o.index)].ready : 0;
}

bool LaneBuilder::is_product(const Operand& o) const {
  return is_statement(o) && o.lane < 0 && scheduled_[at(o.index)].statement.op == Op::multiply;
}

bool LaneBuilder::is_sum_of_lanes(const Operand& o) const {
  return is_statement(o) && o.lane < 0 && scheduled_[at(o.index)].statement.op == Op::sum_lanes;
}

Operand LaneBuilder::numbers(const Tuple& lanes, unsigned negated_lanes) {
  const bool negative = negated_lanes & 1U;
  std::vector<std::pair<int, bool>> key;
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    key.emplace_back(lanes[lane].index, (negated_lanes >> lane & 1U) != (negative ? 1U : 0U));
  Operand result;
  if (std::all_of(key.begin(), key.end(), [&](const auto& element) { return element == key.front(); })) {
    result = {Operand::Kind::constant, key.front().first, false};
  } else if (const auto known = numbers_.find(key); known != numbers_.end()) {
    result = known->second;
  } else {
    Tuple values;
    for (const auto& [index, is_negative] : key) values.push_back({Operand::Kind::constant, index, is_negative});
    result = gather(std::move(values));
    scheduled_.back().late = true;
    numbers_.emplace(std::move(key), result);
  }
  result.negative = negative;
  return result;
}

Operand LaneBuilder::gather(Tuple lanes) {
  Statement s;
  s.op = Op::gather;
  const bool moves = std::any_of(lanes.begin(), lanes.end(), symbolic::is_statement);
  s.lanes = std::move(lanes);
  const Operand result = append(std::move(s), moves ? symbolic::kMoveLatency : 0);
  scheduled_.back().late = true;
  return result;
}

Operand LaneBuilder::product(Operand a, Operand b) {
  Statement s;
  s.op = Op::multiply;
  const bool negative = a.negative != b.negative;
  a.negative = b.negative = false;
  s.a = a;
  s.b = b;
  Operand result = append(std::move(s), symbolic::kLatency);
  result.negative = negative;
  return result;
}

Operand LaneBuilder::quotient(Operand a, Operand b) {
  Operand result = product(a, b);
  Scheduled& scheduled = scheduled_.back();
  scheduled.statement.op = Op::divide;
  scheduled.ready += symbolic::latency(Op::divide) - symbolic::kLatency;
  return result;
}

Operand LaneBuilder::unary(Op op, const Operand& a) {
  Statement s;
  s.op = op;
  s.a = a;
  return append(std::move(s), symbolic::latency(op));
}

Operand LaneBuilder::binary(Op op, const Operand& a, Operand b) {
  if (op == Op::multiply) return product(a, b);
  if (op == Op::divide) return quotient(a, b);
  b.negative = b.negative != (op == Op::subtract);
  return sum({a, b});
}

// Adds up constants of the limbs, which meet when their sums are split into terms, to one term.
void LaneBuilder::fold_constants(std::vector<Operand>& terms) {
  using symbolic::is_constant;
  const auto first = std::find_if(terms.begin(), terms.end(), is_constant);
  if (std::count_if(terms.begin(), terms.end(), is_constant) < 2) return;
  Constant sum;
  for (const Operand& o : terms) {
    if (!is_constant(o)) continue;
    const Constant& c = new_.constants[at(o.index)];
    sum = o.negative ? sum - c : sum + c;
  }
  *first = constant(sum.value() < 0.0 ? -sum : sum);
  first->negative = sum.value() < 0.0;
  terms.erase(std::remove_if(first + 1, terms.end(), is_constant), terms.end());
}

Operand LaneBuilder::sum(std::vector<Operand> terms) {
  fold_constants(terms);
  const auto start = [&](const Operand& o) { return is_product(o) ? ready(o) - symbolic::kLatency : ready(o); };
  std::stable_sort(terms.begin(), terms.end(), [&](const Operand& a, const Operand& b) { return start(a) < start(b); });
  const auto first = std::find_if_not(terms.begin(), terms.end(), [&](const Operand& o) { return is_product(o); });
  // The sum over the limbs is known last. If products can be added up before it is known, the chain starts with them,
  // at the cost of one addition that is not fused.
  const bool is_awaited = first != terms.end() && is_sum_of_lanes(*first) && first - terms.begin() >= 2 &&
                          start(first[-1]) + 2 * symbolic::kLatency <= ready(*first);
  if (first != terms.end() && !is_awaited) std::rotate(terms.begin(), first, first + 1);
  Operand result = terms.front();
  for (std::size_t k = 1; k < terms.size(); ++k) {
    Operand a = result, b = terms[k];
    if (a.negative && !b.negative) std::swap(a, b);
    Statement s;
    s.op = a.negative == b.negative ? Op::add : Op::subtract;
    const bool negative = a.negative;
    a.negative = b.negative = false;
    const int begin = std::max(ready(result), start(terms[k]));
    s.a = a;
    s.b = b;
    result = append(std::move(s), symbolic::kLatency);
    scheduled_.back().ready = begin + symbolic::kLatency;
    result.negative = negative;
  }
  return result;
}

Operand LaneBuilder::sum_lanes(const Operand& a, int lanes) {
  Operand packed_value = width(a) > 1 ? a : gather(Tuple(at(lanes), a));
  const bool negative = packed_value.negative;
  packed_value.negative = false;
  const auto [known, is_new] = sums_of_lanes_.try_emplace(packed_value.index);
  if (is_new) {
    Statement s;
    s.op = Op::sum_lanes;
    s.a = packed_value;
    known->second = append(std::move(s), symbolic::latency(Op::sum_lanes, lanes));
  }
  Operand result = known->second;
  result.negative = negative;
  return result;
}

void LaneBuilder::name(const Operand& value, const Tuple& lanes) {
  if (!is_statement(value) || value.lane >= 0) return;
  Statement& s = scheduled_[at(value.index)].statement;
  if (s.quantity) return;
  std::vector<symbolic::QuantityRef> quantities;
  bool named = true;
  for (const Operand& o : lanes) {
    const Statement& old = old_.statements[at(o.index)];
    if (!old.quantity) return;  // numbered anew
    quantities.push_back(old.quantity);
    named = named && old.named;
  }
  std::optional<symbolic::Quantity> shared = symbolic::common_quantity(quantities);
  if (!shared && named) shared = {"lanes"};
  if (!shared) return;
  s.quantity = std::make_shared<const symbolic::Quantity>(*std::move(shared));
  s.named = named;
}

// Moves statements that bring numbers into lanes to their first user.
void LaneBuilder::settle_late() {
  std::vector<int> user(scheduled_.size(), -1);
  const auto note = [&](const Operand& o, int reader) {
    if (!is_statement(o)) return;
    int& first = user[at(o.index)];
    if (first < 0 || scheduled_[at(reader)].place < scheduled_[at(first)].place) first = reader;
  };
  for (std::size_t i = scheduled_.size(); i-- > 0;) {
    Scheduled& scheduled = scheduled_[i];
    if (scheduled.late && user[i] >= 0) {
      scheduled.place = std::max(scheduled_[at(user[i])].place, 0);
      scheduled.statement.section = scheduled_[at(user[i])].statement.section;
    }
    const int reader = static_cast<int>(i);
    for_each_operand(scheduled.statement, [&](const Operand& o) { note(o, reader); });
  }
}

// The order of the statements: by place, operands before users.
std::vector<int> LaneBuilder::order() const {
  std::vector<std::vector<int>> readers(scheduled_.size());
  std::vector<int> missing(scheduled_.size(), 0);
  const auto note = [&](const Operand& o, std::size_t reader) {
    if (!is_statement(o)) return;
    readers[at(o.index)].push_back(static_cast<int>(reader));
    ++missing[reader];
  };
  for (std::size_t i = 0; i < scheduled_.size(); ++i)
    for_each_operand(scheduled_[i].statement, [&](const Operand& o) { note(o, i); });
  using Entry = std::pair<int, int>;  // place, index
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> ready;
  for (std::size_t i = 0; i < scheduled_.size(); ++i)
    if (missing[i] == 0) ready.emplace(scheduled_[i].place, static_cast<int>(i));
  std::vector<int> result;
  while (!ready.empty()) {
    const int i = ready.top().second;
    ready.pop();
    result.push_back(i);
    for (const int reader : readers[at(i)])
      if (--missing[at(reader)] == 0) ready.emplace(scheduled_[at(reader)].place, reader);
  }
  return result;
}

Program LaneBuilder::program(const std::vector<std::vector<Operand>>& outputs) {
  settle_late();
  const std::vector<int> places = order();
  std::vector<int> index(scheduled_.size(), -1);
  for (std::size_t k = 0; k < places.size(); ++k) index[at(places[k])] = static_cast<int>(k);
  const auto renumber = [&](Operand& o) {
    if (is_statement(o)) o.index = index[at(o.index)];
  };
  Program result = std::move(new_);
  for (const int i : places) {
    Statement s = std::move(scheduled_[at(i)].statement);
    for_each_operand(s, renumber);
    result.statements.push_back(std::move(s));
  }
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    result.outputs[k].values = outputs[k];
    for (Operand& o : result.outputs[k].values) renumber(o);
  }
  return result;
}

}  // namespace robcogen::pass
