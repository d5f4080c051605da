#include "symbolic/count.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "symbolic/blocks.h"
#include "symbolic/fused_products.h"

namespace robcogen::symbolic {
namespace {

// The users of all statements in one list: those of statement i begin at first[i].
struct Uses {
  std::vector<int> first;
  std::vector<int> users;

  std::span<const int> of(std::size_t i) const {
    return std::span(users).subspan(
        static_cast<std::size_t>(first[i]), static_cast<std::size_t>(first[i + 1] - first[i]));
  }
};

// Whether a sum can be fused with this product. A scalar product that a sum with lanes reads is computed before it.
bool is_fusable(const Program& p, int sum, const Operand& product) {
  return product.lane < 0 && p.statements[static_cast<std::size_t>(sum)].width ==
                                 p.statements[static_cast<std::size_t>(product.index)].width;
}

// The users of products only; -1 stands for a user that cannot be fused with the product.
Uses uses_of_products(const Program& p) {
  std::vector<char> is_product(p.statements.size());
  for (std::size_t i = 0; i < p.statements.size(); ++i) is_product[i] = p.statements[i].op == Op::multiply;
  const auto for_each = [&](const auto& note) {
    const auto note_product = [&](const Operand& o, int user) {
      if (is_statement(o) && is_product[static_cast<std::size_t>(o.index)]) note(o, user);
    };
    for (std::size_t i = 0; i < p.statements.size(); ++i)
      for_each_operand(p.statements[i], [&](const Operand& o) { note_product(o, static_cast<int>(i)); });
    for (const OutputArray& array : p.outputs)
      for (const Operand& o : array.values) note_product(o, -1);
  };
  Uses uses{std::vector<int>(p.statements.size() + 1, 0), {}};
  for_each([&](const Operand& o, int) { ++uses.first[static_cast<std::size_t>(o.index) + 1]; });
  std::partial_sum(uses.first.begin(), uses.first.end(), uses.first.begin());
  uses.users.resize(static_cast<std::size_t>(uses.first.back()));
  std::vector<int> next = uses.first;
  for_each([&](const Operand& o, int user) {
    uses.users[static_cast<std::size_t>(next[static_cast<std::size_t>(o.index)]++)] =
        user >= 0 && is_fusable(p, user, o) ? user : -1;
  });
  return uses;
}

int fused(const Program& p) {
  const Uses uses = uses_of_products(p);
  const auto adds = [&](int user) { return user >= 0 && is_sum(p.statements[static_cast<std::size_t>(user)].op); };
  std::vector<std::span<const int>> products;
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const std::span<const int> users = uses.of(i);
    if (!users.empty() && std::all_of(users.begin(), users.end(), adds)) products.push_back(users);
  }
  return fused_products(std::move(products), p.statements.size());
}

int critical_path(const Program& p) {
  std::vector<int> ready(p.statements.size(), 0);
  const auto at = [&](const Operand& o) { return is_statement(o) ? ready[static_cast<std::size_t>(o.index)] : 0; };
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    switch (s.op) {
      case Op::sine:
      case Op::cosine:
        break;  // inputs
      case Op::arc_tangent:
        ready[i] = std::max(at(s.a), at(s.b)) + kArcTangentLatency;
        break;
      case Op::gather:
        for (const Operand& o : s.lanes) ready[i] = std::max(ready[i], at(o));
        if (ready[i] > 0) ready[i] += kMoveLatency;  // otherwise it can be computed ahead
        break;
      case Op::sum_lanes:
        ready[i] = at(s.a);
        for (int width = p.statements[static_cast<std::size_t>(s.a.index)].width; width > 1; width /= 2)
          ready[i] += kMoveLatency + kLatency;
        break;
      case Op::divide:
        ready[i] = std::max(at(s.a), at(s.b)) + kDivisionLatency;
        break;
      case Op::square_root:
        ready[i] = at(s.a) + kDivisionLatency;
        break;
      case Op::multiply:
        ready[i] = std::max(at(s.a), at(s.b)) + kLatency;
        break;
      case Op::add:
      case Op::subtract: {
        ready[i] = std::max(at(s.a), at(s.b)) + kLatency;
        for (const auto& [product, other] : {std::pair(s.a, s.b), std::pair(s.b, s.a)}) {
          if (!is_statement(product) || !is_fusable(p, static_cast<int>(i), product)) continue;
          const Statement& inner = p.statements[static_cast<std::size_t>(product.index)];
          if (inner.op == Op::multiply)
            ready[i] = std::min(ready[i], std::max({at(inner.a), at(inner.b), at(other)}) + kLatency);
        }
        break;
      }
    }
  }
  int longest = 0;
  for (const OutputArray& array : p.outputs)
    for (const Operand& o : array.values) longest = std::max(longest, at(o));
  return longest;
}

bool has_parameters(const Program& p) {
  return std::any_of(p.inputs.begin(), p.inputs.end(), [](const InputArray& a) { return a.role == Role::parameters; });
}

// The program with an input in place of every value that depends on parameters alone.
Program given_parameters(const Program& p) {
  std::vector<bool> is_parameter;
  for (const InputArray& array : p.inputs)
    is_parameter.insert(is_parameter.end(), array.elements.size(), array.role == Role::parameters);
  Program rest = p;
  rest.statements.clear();
  std::vector<int> place(p.statements.size(), -1);  // -1: an input
  const auto is_given = [&](const Operand& o) {
    const auto i = static_cast<std::size_t>(o.index);
    return is_constant(o) || (o.kind == Operand::Kind::input && is_parameter[i]) || (is_statement(o) && place[i] < 0);
  };
  const auto move = [&](Operand& o) {
    if (!is_statement(o)) return;
    const int index = place[static_cast<std::size_t>(o.index)];
    if (index < 0)
      o = {Operand::Kind::input, 0, o.negative};
    else
      o.index = index;
  };
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    Statement s = p.statements[i];
    bool all_given = true;
    for_each_operand(s, [&](const Operand& o) { all_given = all_given && is_given(o); });
    if (all_given) continue;
    place[i] = static_cast<int>(rest.statements.size());
    for_each_operand(s, move);
    rest.statements.push_back(std::move(s));
  }
  for (OutputArray& array : rest.outputs)
    for (Operand& o : array.values) move(o);
  for (InputArray& array : rest.inputs)
    if (array.role == Role::parameters) array.role = Role::value;
  return rest;
}

// The number of instructions that move lanes to outputs. An element that is a lane but in no block costs one.
int moves_to_outputs(const Program& p) {
  int count = 0;
  for (const OutputArray& array : p.outputs)
    count += static_cast<int>(
        std::count_if(array.values.begin(), array.values.end(), [](const Operand& o) { return o.lane >= 0; }));
  for (const Block& block : stores(p).blocks) {
    const auto from_lanes = std::count_if(block.columns.begin(), block.columns.end(), is_statement);
    count += moves(block) - block.width * static_cast<int>(from_lanes);
  }
  return count;
}

// The number of instructions that gather scalars into lanes and extract them.
int moves(const Program& p) {
  int count = 0;
  std::vector<bool> is_loaded(p.statements.size(), false);
  for (const Block& block : loads(p)) {
    count += moves(block);
    for (const Operand& o : block.columns) is_loaded[static_cast<std::size_t>(o.index)] = true;
  }
  std::set<std::pair<int, int>> picked;
  const auto note = [&](const Operand& o) {
    if (is_statement(o) && o.lane > 0) picked.emplace(o.index, o.lane);
  };
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    if (s.op == Op::gather && !is_loaded[i] && !std::all_of(s.lanes.begin(), s.lanes.end(), is_constant))
      count += s.width - 1;
    for_each_operand(s, note);
    if (s.op == Op::sum_lanes)
      for (int width = width_of(p, s.a); width > 1; width /= 2) count += 2;
  }
  return count + static_cast<int>(picked.size()) + moves_to_outputs(p);
}

}  // namespace

OperationCount count(const Program& p) {
  OperationCount c;
  std::set<std::tuple<int, int, int>> angles;  // kinds, indices and lanes of arguments
  for (const Statement& s : p.statements) {
    switch (s.op) {
      case Op::add:
      case Op::subtract:
        ++c.add;
        break;
      case Op::multiply:
        ++c.mul;
        break;
      case Op::divide:
        ++c.div;
        break;
      case Op::square_root:
        ++c.sqrt;
        break;
      case Op::sine:
      case Op::cosine:
        angles.emplace(static_cast<int>(s.a.kind), s.a.index, s.a.lane);
        break;
      case Op::arc_tangent:
        ++c.sincos;
        break;
      case Op::gather:
      case Op::sum_lanes:
        break;
    }
  }
  // The sine of a single lane costs nothing if the sines of all lanes are computed.
  c.sincos += static_cast<int>(std::count_if(angles.begin(), angles.end(), [&](const auto& angle) {
    const auto& [kind, index, lane] = angle;
    return lane < 0 || angles.count({kind, index, -1}) == 0;
  }));
  c.instructions = c.mul + c.add - fused(p);
  c.moves = moves(p);
  c.critical_path = critical_path(p);
  return c;
}

int predicted_time(const Program& program) {
  // Values that depend on parameters alone were split off before congruent limbs went into lanes.
  const OperationCount c =
      has_parameters(program) && !program.has_lanes() ? count(given_parameters(program)) : count(program);
  return std::max(c.critical_path, (c.instructions + c.moves) / 2);
}

int work(const Program& program) {
  if (has_parameters(program)) return work(given_parameters(program));
  int operations = 0;
  for (const Statement& s : program.statements) operations += is_binary(s.op) ? 1 : 0;
  return 2 * operations - fused(program);
}

}  // namespace robcogen::symbolic
