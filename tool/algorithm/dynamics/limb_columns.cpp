#include "algorithm/dynamics/limb_columns.h"

#include <algorithm>
#include <map>

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/spatial/named.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Role;
using symbolic::SolvedColumns;

std::vector<int> ranks(const std::vector<int>& order) {
  std::vector<int> rank(order.size());
  for (std::size_t k = 0; k < rank.size(); ++k) rank[at(order[k])] = static_cast<int>(k);
  return rank;
}

// Rows of H: common rows, then those of each limb.
struct LimbRows {
  int first = 0, count = 0, joints = 0;

  int row(int limb, int joint) const { return first + limb * joints + joint; }
  int limb_of(int row) const { return (row - first) / joints; }
  // The row of another limb that corresponds to a row of the first limb; common rows correspond to themselves.
  int counterpart(int row, int limb) const { return row < first ? row : row + limb * joints; }
};

std::optional<LimbRows> limb_rows(const model::KinematicTree& tree, const EliminationTree& elimination) {
  if (!tree.floating_base) return std::nullopt;
  LimbRows limbs{6, 0, 0};
  const int rows = static_cast<int>(elimination.order.size());
  for (int r = limbs.first; r < rows; ++r) {
    const std::vector<int>& ancestors = elimination.ancestors[at(r)];
    if (std::all_of(ancestors.begin(), ancestors.end(), [&](int a) { return a < limbs.first; })) ++limbs.count;
  }
  const std::vector<int> counts = {2, 4, 8, 16};
  if (std::find(counts.begin(), counts.end(), limbs.count) == counts.end()) return std::nullopt;
  if ((rows - limbs.first) % limbs.count != 0) return std::nullopt;
  limbs.joints = (rows - limbs.first) / limbs.count;
  for (int limb = 0; limb < limbs.count; ++limb) {
    for (int joint = 0; joint < limbs.joints; ++joint) {
      std::vector<int> expected;
      for (const int a : elimination.ancestors[at(limbs.row(0, joint))]) {
        if (a >= limbs.first + limbs.joints) return std::nullopt;
        expected.push_back(limbs.counterpart(a, limb));
      }
      if (elimination.ancestors[at(limbs.row(limb, joint))] != expected) return std::nullopt;
    }
  }
  return limbs;
}

// Whether each column is zero except in common rows and those of its own limb.
bool is_of_limbs(const SolvedColumns& solved, const SolvedColumns::Block& block, const LimbRows& limbs) {
  const symbolic::Program& program = solved.right_sides;
  const symbolic::OutputArray& array = program.outputs[at(block.output)];
  if (block.columns != limbs.count * limbs.joints) return false;
  for (int c = 0; c < block.columns; ++c) {
    for (int r = limbs.first; r < array.rows; ++r) {
      const symbolic::Operand& value = array.values[at(r + c * array.rows)];
      const bool zero = is_constant(value) && program.constants[at(value.index)].value() == 0;
      if (!zero && limbs.limb_of(r) != c / limbs.joints) return false;
    }
  }
  return true;
}

// Elements of the factor in rows of each limb, as in SolvedColumns::Limbs::own: by row, first those of L, then that of
// D.
std::vector<int> own_elements(const EliminationTree& elimination, const LimbRows& limbs) {
  const std::vector<std::pair<int, int>> elements = elements_of_factor(elimination);
  const std::vector<int> rank = ranks(elimination.order);
  std::map<std::pair<int, int>, int> place;
  for (std::size_t k = 0; k < elements.size(); ++k) place[elements[k]] = static_cast<int>(k);
  std::vector<int> own;
  for (int joint = 0; joint < limbs.joints; ++joint) {
    const int row = limbs.row(0, joint);
    for (const int a : elimination.ancestors[at(row)])
      for (int limb = 0; limb < limbs.count; ++limb)
        own.push_back(place.at({rank[at(limbs.counterpart(row, limb))], rank[at(limbs.counterpart(a, limb))]}));
    for (int limb = 0; limb < limbs.count; ++limb)
      own.push_back(static_cast<int>(elements.size()) + rank[at(limbs.counterpart(row, limb))]);
  }
  return own;
}

symbolic::Program limb_solution(
    const model::KinematicTree& tree,
    const EliminationTree& elimination,
    const LimbRows& limbs,
    const std::string& name) {
  const std::vector<int> rank = ranks(elimination.order);
  const std::vector<std::string> names = coordinate_names(tree);
  std::vector<std::string> ordered, own_names, limb_names, b_names(names.begin(), names.begin() + limbs.first);
  for (const int row : elimination.order) ordered.push_back(names[at(row)]);
  for (int joint = 0; joint < limbs.joints; ++joint) {
    const int row = limbs.row(0, joint);
    b_names.push_back(names[at(row)]);
    for (const int a : elimination.ancestors[at(row)]) own_names.push_back(names[at(row)] + "_" + names[at(a)]);
    own_names.push_back(names[at(row)]);
  }
  for (int limb = 0; limb < limbs.count; ++limb) limb_names.push_back(names[at(limbs.row(limb, 0))]);

  ProgramTrace trace;
  LdlFactors factors = given_factors(trace, elimination, ordered);
  const std::vector<Expression> own = trace.input("own", Role::value, own_names);
  const std::vector<Expression> is_limb = trace.input("is_limb", Role::value, limb_names);
  const std::vector<Expression> given = trace.input("b", Role::value, b_names);
  trace.section("solution", "one column per limb");
  // The lane's limb takes the rows of the first limb; the rows of the others are zero.
  LdlFactors in_place = factors;
  std::vector<Expression> b(names.size());
  for (std::size_t k = 0; k < given.size(); ++k) b[at(rank[k])] = given[k];
  std::size_t next = 0;
  for (int joint = 0; joint < limbs.joints; ++joint) {
    const int row = limbs.row(0, joint);
    for (const int a : elimination.ancestors[at(row)]) in_place.l(rank[at(row)], rank[at(a)]) = own[next++];
    in_place.inverse_d[at(rank[at(row)])] = own[next++];
  }
  std::vector<Expression> half = first_half(in_place, b);
  describe_elements("b", ordered, half);
  for (int joint = 0; joint < limbs.joints; ++joint) {
    const std::size_t first = at(rank[at(limbs.row(0, joint))]);
    const Expression scaled = in_place.inverse_d[first] * half[first];
    for (int limb = 0; limb < limbs.count; ++limb) {
      const std::size_t k = at(rank[at(limbs.row(limb, joint))]);
      half[k] = scaled;
      factors.inverse_d[k] = is_limb[at(limb)];
    }
  }
  const std::vector<Expression> solution = second_half(factors, half);
  std::vector<Expression> x;
  for (std::size_t row = 0; row < names.size(); ++row) {
    x.push_back(solution[at(rank[row])]);
    described(coordinate("x", names[row]), x.back());
  }
  trace.output("x", Role::value, x);
  return trace.program(name);
}

}  // namespace

std::vector<std::pair<int, int>> elements_of_factor(const EliminationTree& elimination) {
  const std::vector<int> rank = ranks(elimination.order);
  std::vector<std::pair<int, int>> elements;
  for (std::size_t k = 0; k < rank.size(); ++k)
    for (const int ancestor : elimination.ancestors[at(elimination.order[k])])
      elements.emplace_back(static_cast<int>(k), rank[at(ancestor)]);
  return elements;
}

std::vector<std::string> labels_of_factor(const EliminationTree& elimination, const std::vector<std::string>& names) {
  std::vector<std::string> labels;
  for (const auto& [row, column] : elements_of_factor(elimination))
    labels.push_back(names[at(row)] + "_" + names[at(column)]);
  labels.insert(labels.end(), names.begin(), names.end());
  return labels;
}

LdlFactors factor_of(const EliminationTree& elimination, const std::vector<Expression>& numbers) {
  const int size = static_cast<int>(elimination.order.size());
  LdlFactors factors{SquareMatrix(size), {}};
  auto next = numbers.begin();
  for (const auto& [row, column] : elements_of_factor(elimination)) factors.l(row, column) = *next++;
  factors.inverse_d.assign(next, next + size);
  return factors;
}

std::vector<Expression> numbers_of(const EliminationTree& elimination, const LdlFactors& factors) {
  std::vector<Expression> numbers;
  for (const auto& [row, column] : elements_of_factor(elimination)) numbers.push_back(factors.l(row, column));
  numbers.insert(numbers.end(), factors.inverse_d.begin(), factors.inverse_d.end());
  return numbers;
}

LdlFactors given_factors(
    ProgramTrace& trace,
    const EliminationTree& elimination,
    const std::vector<std::string>& names) {
  return factor_of(elimination, trace.input("factor", Role::value, labels_of_factor(elimination, names)));
}

void find_limbs(const model::KinematicTree& tree, const std::string& name, SolvedColumns& solved) {
  const EliminationTree elimination = elimination_tree(tree);
  const std::optional<LimbRows> limbs = limb_rows(tree, elimination);
  if (!limbs) return;
  bool any = false;
  for (SolvedColumns::Block& block : solved.blocks) any |= block.of_limbs = is_of_limbs(solved, block, *limbs);
  if (!any) return;
  solved.limbs = {
      limbs->count, limbs->joints, own_elements(elimination, *limbs), limb_solution(tree, elimination, *limbs, name)};
}

}  // namespace robcogen::algorithm
