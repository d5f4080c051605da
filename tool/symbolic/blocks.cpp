#include "symbolic/blocks.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "support/index.h"

namespace robcogen::symbolic {
namespace {

// A value whose lanes are array elements at equal distances.
struct Column {
  int stride = 0;
  int width = 0;
  int first = 0;
  Operand value;
};

std::tuple<int, int, int> place(const Column& c) {
  return {c.stride, c.width, c.first};
}

// Joins columns that follow each other into blocks. `between` may supply a missing column between two of them.
template <class Between>
std::vector<Block> joined(int array, std::vector<Column> columns, const Between& between) {
  std::sort(columns.begin(), columns.end(), [](const Column& a, const Column& b) { return place(a) < place(b); });
  std::vector<Block> blocks;
  for (const Column& c : columns) {
    if (!blocks.empty() && blocks.back().stride == c.stride && blocks.back().width == c.width) {
      Block& last = blocks.back();
      const int end = last.first + static_cast<int>(last.columns.size());
      if (c.first == end + 1)
        if (const std::optional<Operand> filling = between(last, end)) last.columns.push_back(*filling);
      if (c.first == last.first + static_cast<int>(last.columns.size())) {
        last.columns.push_back(c.value);
        continue;
      }
    }
    blocks.push_back({array, c.first, c.stride, c.width, {c.value}});
  }
  std::erase_if(blocks, [](const Block& block) { return block.columns.size() < 2; });
  return blocks;
}

// Groups the elements of an output that are lanes of values into columns; each element is in one column.
std::vector<Column> columns_of(const Program& p, const OutputArray& array) {
  std::map<std::tuple<int, int, bool>, std::vector<int>> places;  // by statement, lane and sign
  const auto key = [](const Operand& o, int lane) { return std::tuple(o.index, lane, o.negative); };
  const auto count = static_cast<int>(array.values.size());
  for (int k = 0; k < count; ++k) {
    const Operand& o = array.values[at(k)];
    if (o.lane >= 0) places[key(o, o.lane)].push_back(k);
  }
  std::vector<bool> taken(array.values.size(), false);
  const auto is_lane = [&](int k, const Operand& value, int lane) {
    return k < count && !taken[at(k)] && array.values[at(k)] == Operand{value.kind, value.index, value.negative, lane};
  };
  std::vector<Column> columns;
  for (int first = 0; first < count; ++first) {
    const Operand& o = array.values[at(first)];
    if (o.lane != 0 || taken[at(first)]) continue;
    const int width = p.statements[at(o.index)].width;
    for (const int second : places[key(o, 1)]) {
      const int stride = second - first;
      if (stride <= 0) continue;
      bool is_column = true;
      for (int lane = 1; lane < width; ++lane) is_column = is_column && is_lane(first + lane * stride, o, lane);
      if (!is_column) continue;
      for (int lane = 0; lane < width; ++lane) taken[at(first + lane * stride)] = true;
      columns.push_back({stride, width, first, {o.kind, o.index, o.negative}});
      break;
    }
  }
  return columns;
}

// The number of stores that write this many equal elements, with vectors of four.
int stores_of(int count) {
  return count < 4 ? count : (count + 3) / 4;
}

// Runs of elements that equal one constant and are in no block. A run may span elements that are written later, if that
// takes no more stores.
std::vector<Fill> fills_of(int index, const OutputArray& array, const std::vector<bool>& taken) {
  std::vector<Fill> fills;
  const auto count = static_cast<int>(array.values.size());
  for (int k = 0; k < count; ++k) {
    const Operand& o = array.values[at(k)];
    if (!is_constant(o) || taken[at(k)]) continue;
    int end = k + 1;
    while (end < count && array.values[at(end)] == o && !taken[at(end)]) ++end;
    Fill run = {index, k, end - k, o};
    if (!fills.empty() && fills.back().value == o) {
      const int all = end - fills.back().first;
      if (stores_of(all) <= stores_of(fills.back().count) + stores_of(run.count)) {
        run = {index, fills.back().first, all, o};
        fills.pop_back();
      }
    }
    fills.push_back(run);
    k = end - 1;
  }
  std::erase_if(fills, [](const Fill& fill) { return fill.count < 4; });
  return fills;
}

}  // namespace

Stores stores(const Program& p) {
  Stores result;
  if (!p.has_lanes()) return result;
  for (std::size_t i = 0; i < p.outputs.size(); ++i) {
    const OutputArray& array = p.outputs[i];
    const auto constant = [&](const Block& block, int first) -> std::optional<Operand> {
      const Operand& value = array.values[at(first)];
      for (int lane = 0; lane < block.width; ++lane)
        if (array.values[at(first + lane * block.stride)] != value) return std::nullopt;
      return is_constant(value) ? std::optional(value) : std::nullopt;
    };
    const std::vector<Block> blocks = joined(static_cast<int>(i), columns_of(p, array), constant);
    std::vector<bool> taken(array.values.size(), false);
    for (const Block& block : blocks)
      for (int lane = 0; lane < block.width; ++lane)
        for (std::size_t k = 0; k < block.columns.size(); ++k) taken[at(block.first + lane * block.stride) + k] = true;
    const std::vector<Fill> fills = fills_of(static_cast<int>(i), array, taken);
    result.blocks.insert(result.blocks.end(), blocks.begin(), blocks.end());
    result.fills.insert(result.fills.end(), fills.begin(), fills.end());
  }
  return result;
}

std::vector<Block> loads(const Program& p) {
  std::vector<std::pair<int, int>> places;  // array and element of each flat input index
  for (std::size_t i = 0; i < p.inputs.size(); ++i)
    for (std::size_t k = 0; k < p.inputs[i].elements.size(); ++k)
      places.emplace_back(static_cast<int>(i), static_cast<int>(k));
  std::vector<std::vector<Column>> columns(p.inputs.size());
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    if (s.op != Op::gather || s.width < 2) continue;
    const Operand first = s.lanes[0];
    const int stride = s.lanes[1].index - first.index;
    bool is_column = first.kind == Operand::Kind::input && stride > 0;
    for (int lane = 0; lane < s.width; ++lane)
      is_column = is_column && s.lanes[at(lane)] == Operand{first.kind, first.index + lane * stride, false} &&
                  places[at(s.lanes[at(lane)].index)].first == places[at(first.index)].first;
    if (!is_column) continue;
    const auto [array, element] = places[at(first.index)];
    columns[at(array)].push_back({stride, s.width, element, {Operand::Kind::statement, static_cast<int>(i), false}});
  }
  std::vector<Block> result;
  for (std::size_t i = 0; i < p.inputs.size(); ++i) {
    const std::vector<Block> blocks =
        joined(static_cast<int>(i), columns[i], [](const Block&, int) { return std::optional<Operand>(); });
    result.insert(result.end(), blocks.begin(), blocks.end());
  }
  return result;
}

// With four lanes, four columns take eight shuffles, and three columns that leave no gap between the lanes take six.
// Two columns take two shuffles and two more stores, a single column at most three moves. Wider blocks are moved four
// lanes at a time.
int moves(const Block& block) {
  const auto columns = static_cast<int>(block.columns.size());
  if (block.width < 4) return columns;
  const int rest = columns % 4;
  const int of_rest = rest == 3 && columns == 3 && block.stride == 3 ? 6 : rest / 2 * 4 + rest % 2 * 3;
  return block.width / 4 * (columns / 4 * 8 + of_rest);
}

}  // namespace robcogen::symbolic
