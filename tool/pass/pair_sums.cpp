#include "pass/pair_sums.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "pass/statements.h"
#include "support/index.h"

namespace robcogen::pass {
namespace {

using symbolic::Op;
using symbolic::Program;
using symbolic::Statement;

bool is_sum_of_lanes(const Statement& s) {
  return s.op == Op::sum_lanes;
}

// By statement: the length of the longest chain of sums over lanes that it depends on. Sums of equal length do not
// depend on each other.
std::vector<int> depths(const Program& p) {
  std::vector<int> result;
  for (const Statement& s : p.statements) {
    int depth = 0;
    for_each_read(s, [&](int read) {
      depth = std::max(depth, result[at(read)] + (is_sum_of_lanes(p.statements[at(read)]) ? 1 : 0));
    });
    result.push_back(depth);
  }
  return result;
}

constexpr int kAlone = -1;

// By statement: the other sum of its pair. Sums of one section are paired first, then the rest.
std::vector<int> partners(const Program& p) {
  const std::vector<int> depth = depths(p);
  std::vector<int> result(p.statements.size(), kAlone);
  for (const bool in_section : {true, false}) {
    std::map<std::tuple<int, int, int>, int> waiting;  // by section, depth and number of lanes
    for (std::size_t i = 0; i < p.statements.size(); ++i) {
      const Statement& s = p.statements[i];
      if (!is_sum_of_lanes(s) || result[i] != kAlone) continue;
      const std::tuple key(in_section ? s.section : 0, depth[i], width_of(p, s.a));
      const auto [first, is_first] = waiting.try_emplace(key, static_cast<int>(i));
      if (is_first) continue;
      result[i] = first->second;
      result[at(first->second)] = static_cast<int>(i);
      waiting.erase(first);
    }
  }
  return result;
}

// Keeps statements in their order, except that all that the second sum of a pair needs goes before the first one.
class PairOrder {
 public:
  PairOrder(const Program& p, std::vector<int> partners)
      : program_(p), partners_(std::move(partners)), is_placed_(p.statements.size(), false) {}

  std::vector<int> run() {
    for (std::size_t i = 0; i < program_.statements.size(); ++i) place(static_cast<int>(i));
    return std::move(order_);
  }

 private:
  void place(int i) {
    if (is_placed_[at(i)]) return;
    const int partner = partners_[at(i)];
    place_operands(i);
    if (partner != kAlone) place_operands(partner);
    append(i);
    if (partner != kAlone) append(partner);
  }

  void place_operands(int i) {
    for_each_read(program_.statements[at(i)], [&](int read) { place(read); });
  }

  void append(int i) {
    is_placed_[at(i)] = true;
    order_.push_back(i);
  }

  const Program& program_;
  std::vector<int> partners_;
  std::vector<bool> is_placed_;
  std::vector<int> order_;
};

}  // namespace

Program pair_sums(Program program) {
  std::vector<int> same(program.statements.size());
  std::iota(same.begin(), same.end(), 0);
  const std::vector<int> order = PairOrder(program, partners(program)).run();
  return rearrange(std::move(program), order, same);
}

}  // namespace robcogen::pass
