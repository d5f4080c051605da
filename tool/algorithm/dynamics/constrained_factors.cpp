#include "algorithm/dynamics/constrained_factors.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/limb_columns.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

// The rows of H whose coordinates move a frame, and those that elimination changes from there, as ordered rows.
std::vector<int> moving_rows(
    const model::KinematicTree& tree,
    const EliminationTree& elimination,
    const model::Frame& frame) {
  const int base = tree.floating_base ? 6 : 0;
  std::vector<int> joints;
  for (int j = tree.links[at(tree.link_of(frame))].parent_joint; j >= 0; j = tree.parent_joint_of(j))
    joints.push_back(j);
  std::set<int> rows;
  for (int k = 0; k < base; ++k) rows.insert(k);
  for (const int coordinate : coordinates_of(tree, joints)) {
    rows.insert(base + coordinate);
    const std::vector<int>& ancestors = elimination.ancestors[at(base + coordinate)];
    rows.insert(ancestors.begin(), ancestors.end());
  }
  std::vector<int> ordered;
  for (std::size_t k = 0; k < elimination.order.size(); ++k)
    if (rows.count(elimination.order[k]) > 0) ordered.push_back(static_cast<int>(k));
  return ordered;
}

// The elements below the diagonal that elimination from the last row leaves. Rows that share a row of H have an element
// in W.
std::vector<std::pair<int, int>> elements_of_contacts(const std::vector<std::vector<int>>& halves) {
  const std::size_t n = halves.size();
  std::vector<std::vector<bool>> is_set(n, std::vector<bool>(n));
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c < r; ++c)
      is_set[r][c] =
          std::find_first_of(halves[r].begin(), halves[r].end(), halves[c].begin(), halves[c].end()) != halves[r].end();
  std::vector<std::pair<int, int>> elements;
  for (std::size_t k = n; k-- > 0;)
    for (std::size_t i = 0; i < k; ++i) {
      if (!is_set[k][i]) continue;
      elements.emplace_back(static_cast<int>(k), static_cast<int>(i));
      for (std::size_t j = 0; j < i; ++j)
        if (is_set[k][j]) is_set[i][j] = true;
    }
  return elements;
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// An internal fault: the structure lacks an element.
void require_zeros(const std::vector<Expression>& values, const std::vector<int>& places) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!values[k].is_zero() && !std::binary_search(places.begin(), places.end(), static_cast<int>(k)))
      throw std::logic_error("the factor of contacts has elements outside of its structure");
}

}  // namespace

ConstrainedStructure::ConstrainedStructure(const model::KinematicTree& tree, const ContactFrames& contacts)
    : rows(joined(coordinate_names(tree), force_elements(contacts))),
      elimination(elimination_tree(tree)),
      order(tree, SquareMatrix(static_cast<int>(elimination.order.size()))),
      contact_rows(motion_elements(contacts)) {
  for (const model::ContactFrame& contact : contacts) {
    const std::vector<int> moving = moving_rows(tree, elimination, contact.frame);
    halves.insert(halves.end(), contact.is_surface ? 6 : 3, moving);
  }
  of_contacts = elements_of_contacts(halves);
}

ConstrainedFactors constrained_factors(const SwitchedContacts& contacts) {
  return {contacts.system.factors(), contacts.system.halves(), contacts.active.factors(), contacts.active.activity()};
}

std::vector<Expression> numbers_of(const ConstrainedStructure& structure, const ConstrainedFactors& factors) {
  std::vector<Expression> numbers = numbers_of(structure.elimination, factors.of_inertia);
  for (std::size_t r = 0; r < structure.halves.size(); ++r) {
    require_zeros(factors.halves[r], structure.halves[r]);
    for (const int k : structure.halves[r]) numbers.push_back(factors.halves[r][at(k)]);
  }
  for (const auto& [row, column] : structure.of_contacts) numbers.push_back(factors.of_contacts.l(row, column));
  const std::vector<Expression>& inverse_d = factors.of_contacts.inverse_d;
  numbers.insert(numbers.end(), inverse_d.begin(), inverse_d.end());
  numbers.insert(numbers.end(), factors.active.begin(), factors.active.end());
  return numbers;
}

std::vector<std::string> labels_of(const ConstrainedStructure& structure) {
  std::vector<std::string> labels = labels_of_factor(structure.elimination, structure.order.names);
  const std::vector<std::string>& names = structure.contact_rows;
  for (std::size_t r = 0; r < names.size(); ++r)
    for (const int k : structure.halves[r]) labels.push_back("Y_" + names[r] + "_" + structure.order.names[at(k)]);
  for (const auto& [row, column] : structure.of_contacts) labels.push_back(names[at(row)] + "_" + names[at(column)]);
  labels.insert(labels.end(), names.begin(), names.end());
  for (const std::string& name : names) labels.push_back("active_" + name);
  return labels;
}

ConstrainedFactors factors_from(const ConstrainedStructure& structure, const std::vector<Expression>& numbers) {
  const std::size_t rows = structure.halves.size(), size = structure.elimination.order.size();
  ConstrainedFactors factors{
      factor_of(structure.elimination, numbers),
      std::vector<std::vector<Expression>>(rows, std::vector<Expression>(size)),
      {SquareMatrix(static_cast<int>(rows)), {}},
      {}};
  auto next = numbers.begin() + static_cast<std::ptrdiff_t>(elements_of_factor(structure.elimination).size() + size);
  for (std::size_t r = 0; r < rows; ++r)
    for (const int k : structure.halves[r]) factors.halves[r][at(k)] = *next++;
  for (const auto& [row, column] : structure.of_contacts) factors.of_contacts.l(row, column) = *next++;
  factors.of_contacts.inverse_d.assign(next, next + static_cast<std::ptrdiff_t>(rows));
  factors.active.assign(next + static_cast<std::ptrdiff_t>(rows), numbers.end());
  return factors;
}

std::vector<Expression> solve(
    const ConstrainedStructure& structure,
    const ConstrainedFactors& factors,
    const std::vector<Expression>& b,
    const std::string& column) {
  const std::size_t size = structure.elimination.order.size(), rows = structure.halves.size();
  const std::vector<std::string>& names = structure.order.names;
  std::vector<Expression> half = first_half(
      factors.of_inertia, structure.order.ordered({b.begin(), b.begin() + static_cast<std::ptrdiff_t>(size)}));
  std::vector<Expression> scaled, missing;
  for (std::size_t k = 0; k < size; ++k) {
    described(coordinate("b", names[k], column), half[k]);
    scaled.push_back(factors.of_inertia.inverse_d[k] * half[k]);
  }
  for (std::size_t r = 0; r < rows; ++r) {
    Expression sum = b[size + r];
    for (std::size_t k = 0; k < size; ++k) sum -= factors.halves[r][k] * scaled[k];
    missing.push_back(factors.active[r] * sum);
    described(coordinate("b", structure.contact_rows[r], column), missing.back());
  }
  const std::vector<Expression> f = second_half(factors.of_contacts, first_half(factors.of_contacts, missing));
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t k = 0; k < size; ++k) half[k] += factors.halves[r][k] * f[r];
  std::vector<Expression> x = structure.order.unordered(second_half(factors.of_inertia, half));
  x.insert(x.end(), f.begin(), f.end());
  describe_elements("x", structure.rows, x, column);
  return x;
}

}  // namespace robcogen::algorithm
