// The factor L of H = L^T L and the functions that use it, along the ancestors of each coordinate only (Featherstone
// 2008, sec. 6.5): L(i, j) is zero unless j is i or an ancestor of i, because elimination from the leaves fills nothing
// in.
#include <algorithm>
#include <array>
#include <utility>

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/elimination.h"
#include "algorithm/spatial/named.h"
#include "support/index.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Role;

// What a row of H stands for.
struct Coordinate {
  std::string name;            // of the joint, or `base_wx`, …
  std::string short_name;      // of the joint, or `wx`, …
  std::string link;            // the link that it moves
  std::vector<int> ancestors;  // nearest last
};

std::vector<Coordinate> coordinates_of(const KinematicTree& tree, const EliminationTree& elimination) {
  static const std::array<const char*, 6> kBase = {"base_wx", "base_wy", "base_wz", "base_vx", "base_vy", "base_vz"};
  std::vector<Coordinate> list;
  if (tree.floating_base)
    for (const char* name : kBase) list.push_back({name, name + 5, tree.links[0].name, {}});
  for (const int j : tree.coordinates()) {
    const model::Joint& joint = tree.joints[at(j)];
    list.push_back({joint.name, joint.name, tree.links[at(joint.child)].name, {}});
  }
  for (std::size_t i = 0; i < list.size(); ++i) list[i].ancestors = elimination.ancestors[i];
  return list;
}

void enter(ProgramTrace& trace, const Coordinate& c, const std::string& what) {
  trace.section(c.link, what + " " + c.name);
}

// How a factor is given to a program.
enum class Given {
  matrices,  // as the first inputs: L and inverse_diagonal
  numbers,   // as the input `factor`: those of its numbers that solutions read
};

// A factor that was computed before.
struct GivenFactor {
  GivenFactor(ProgramTrace& trace, const KinematicTree& tree, const Program& factor, Given given = Given::matrices)
      : GivenFactor(trace, tree, elimination_tree(tree), factor, given) {}
  GivenFactor(
      ProgramTrace& trace,
      const KinematicTree& tree,
      const EliminationTree& elimination,
      const Program& factor,
      Given given)
      : coordinates(coordinates_of(tree, elimination)), order(elimination.order), L(size()) {
    // Elements that the factor's own program leaves at zero, whatever q is, are zero here too.
    const auto is_zero = [&](int i, int j) {
      const Operand& value = factor.outputs[0].values[at(j * size() + i)];
      return is_constant(value) && factor.constants[at(value.index)].value() == 0;
    };
    const auto label = [&](int i, int j) { return coordinates[at(i)].name + "_" + coordinates[at(j)].name; };
    for (int i = 0; i < size(); ++i)
      for (const int j : coordinates[at(i)].ancestors)
        if (!is_zero(i, j)) places.emplace_back(i, j);
    std::vector<std::string> labels, diagonal;
    for (const Coordinate& c : coordinates) diagonal.push_back(c.name);
    if (given == Given::numbers) {
      for (const auto& [i, j] : places) labels.push_back(label(i, j));
      labels.insert(labels.end(), diagonal.begin(), diagonal.end());
      const std::vector<Expression> numbers = trace.input("factor", Role::value, labels);
      for (std::size_t k = 0; k < places.size(); ++k) L(places[k].first, places[k].second) = numbers[k];
      inverse_diagonal.assign(numbers.end() - size(), numbers.end());
      return;
    }
    for (int j = 0; j < size(); ++j)
      for (int i = 0; i < size(); ++i) labels.push_back(label(i, j));
    const std::vector<Expression> elements = trace.input("L", Role::inertia_factor, labels);
    for (int j = 0; j < size(); ++j)
      for (int i = 0; i < size(); ++i)
        if (!is_zero(i, j)) L(i, j) = elements[at(j * size() + i)];
    inverse_diagonal = trace.input("inverse_diagonal", Role::inverse_diagonal, diagonal);
  }

  std::vector<Coordinate> coordinates;
  std::vector<int> order;
  SquareMatrix L;
  std::vector<Expression> inverse_diagonal;
  std::vector<std::pair<int, int>> places;  // of the elements of L below its diagonal that are not zero

  int size() const { return static_cast<int>(coordinates.size()); }
  std::vector<Expression> numbers() const {
    std::vector<Expression> list;
    for (const auto& [i, j] : places) list.push_back(L(i, j));
    list.insert(list.end(), inverse_diagonal.begin(), inverse_diagonal.end());
    return list;
  }
};

// Replaces y by L^-T y.
void solve_transpose(ProgramTrace& trace, const GivenFactor& f, std::vector<Expression>& y) {
  for (auto i = f.order.rbegin(); i != f.order.rend(); ++i) {
    const Coordinate& c = f.coordinates[at(*i)];
    enter(trace, c, "transpose of L: element");
    described(coordinate("r", c.short_name), y[at(*i)]);
    y[at(*i)] = described(coordinate("z", c.short_name), y[at(*i)] * f.inverse_diagonal[at(*i)]);
    for (const int j : c.ancestors) y[at(j)] -= f.L(*i, j) * y[at(*i)];
  }
}

// Replaces y by L^-1 y.
void solve_factor(ProgramTrace& trace, const GivenFactor& f, std::vector<Expression>& y) {
  for (const int i : f.order) {
    const Coordinate& c = f.coordinates[at(i)];
    enter(trace, c, "L: element");
    for (const int j : c.ancestors) y[at(i)] -= f.L(i, j) * y[at(j)];
    described(coordinate("Ly", c.short_name), y[at(i)]);
    y[at(i)] = described(coordinate("y", c.short_name), y[at(i)] * f.inverse_diagonal[at(i)]);
  }
}

std::vector<Expression> vector_input(ProgramTrace& trace, const GivenFactor& f, const std::string& name) {
  std::vector<std::string> elements;
  for (const Coordinate& c : f.coordinates) elements.push_back(c.name);
  return trace.input(name, Role::value, elements);
}

// The inverse of L, or of H, as solutions for the columns of the identity.
symbolic::SolvedColumns inverse_in_columns(
    const KinematicTree& tree,
    const Program& factor,
    const std::string& name,
    bool is_of_L) {
  ProgramTrace right_sides;
  const GivenFactor given(right_sides, tree, factor);
  SquareMatrix identity(given.size());
  for (int i = 0; i < given.size(); ++i) identity(i, i) = right_sides.graph.one();
  right_sides.output("inverse", Role::matrix, given.size(), given.size(), identity.columns());
  right_sides.output("factor", Role::value, given.numbers());

  ProgramTrace solution;
  const GivenFactor f(solution, tree, factor, Given::numbers);
  std::vector<Expression> x = vector_input(solution, f, "b");
  if (!is_of_L) solve_transpose(solution, f, x);
  solve_factor(solution, f, x);
  solution.output("x", Role::value, x);
  symbolic::SolvedColumns result{right_sides.program(name + "_right_sides"), solution.program(name + "_column"), {}};
  result.add_blocks({{"inverse"}});
  return result;
}

SquareMatrix inverse_of(ProgramTrace& trace, const GivenFactor& f) {
  SquareMatrix inverse(f.size());
  for (const int i : f.order) {
    const Coordinate& c = f.coordinates[at(i)];
    enter(trace, c, "inverse of L: row");
    inverse(i, i) = f.inverse_diagonal[at(i)];
    for (const int j : c.ancestors) {
      Expression sum;
      for (const int k : c.ancestors) sum += f.L(i, k) * inverse(k, j);
      inverse(i, j) = -(f.inverse_diagonal[at(i)] * sum);
      described(coordinates("Linv", c.short_name, f.coordinates[at(j)].short_name), inverse(i, j));
    }
  }
  return inverse;
}

// How the elimination of a row changes the rows of its ancestors. Both forms give the same result; the pivot is
// d = L(i, i)^2.
enum class Elimination {
  products_of_L,  // H(j, k) -= L(i, j) L(i, k): fewest operations
  reciprocals,    // H(j, k) -= H(i, j) / d H(i, k): the next pivot does not wait for a square root
};

Program factor(
    const KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation,
    Elimination elimination) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position});
  const EliminationTree tied = elimination_tree(tree);
  const std::vector<Coordinate> coordinates = coordinates_of(tree, tied);
  const std::vector<int>& order = tied.order;
  const int size = static_cast<int>(coordinates.size());
  SquareMatrix H = joint_space_inertia(TracedRobot(trace, in.q, formulation));
  SquareMatrix L(size);
  std::vector<Expression> inverse_diagonal(at(size));
  for (auto next = order.rbegin(); next != order.rend(); ++next) {
    const int i = *next;
    const Coordinate& c = coordinates[at(i)];
    enter(trace, c, "factor: row");
    const auto element = [&](const char* matrix, int j, const char* state = "") {
      return algorithm::coordinates(matrix, c.short_name, coordinates[at(j)].short_name, state);
    };
    described(element("E", i), H(i, i));
    for (const int j : c.ancestors) described(element("E", j), H(i, j));
    L(i, i) = described(element("L", i), sqrt(H(i, i)));
    const bool waits = elimination == Elimination::products_of_L;
    const Expression reciprocal = trace.graph.one() / (waits ? L(i, i) : H(i, i));
    inverse_diagonal[at(i)] = described(element("L", i, "inv"), waits ? reciprocal : L(i, i) * reciprocal);
    described(coordinate("D", c.short_name, "inv"), reciprocal);
    for (const int j : c.ancestors) {
      L(i, j) = described(element("L", j), H(i, j) * inverse_diagonal[at(i)]);
    }
    const SquareMatrix& row = waits ? L : H;
    for (const int j : c.ancestors) {
      const Expression share = described(element("E", j, "by_D"), waits ? L(i, j) : H(i, j) * reciprocal);
      for (const int k : coordinates[at(j)].ancestors) H(j, k) -= share * row(i, k);
      H(j, j) -= share * row(i, j);
    }
  }
  trace.output("L", Role::inertia_factor, size, size, L.columns());
  trace.output("inverse_diagonal", Role::inverse_diagonal, inverse_diagonal);
  return trace.program(name);
}

}  // namespace

Program joint_space_inertia_factor(const KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Program small = factor(tree, name, formulation, Elimination::products_of_L);
  Program quick = factor(tree, name, formulation, Elimination::reciprocals);
  return symbolic::predicted_time(quick) < symbolic::predicted_time(small) ? quick : small;
}

Program inertia_factor_solve(const KinematicTree& tree, const Program& factor, const std::string& name) {
  ProgramTrace trace;
  const GivenFactor f(trace, tree, factor);
  std::vector<Expression> y = vector_input(trace, f, "x");
  solve_transpose(trace, f, y);
  solve_factor(trace, f, y);
  trace.output("y", Role::value, y);
  return trace.program(name);
}

Program inertia_factor_inverse_L(const KinematicTree& tree, const Program& factor, const std::string& name) {
  ProgramTrace trace;
  const GivenFactor f(trace, tree, factor);
  trace.output("inverse", Role::matrix, f.size(), f.size(), inverse_of(trace, f).columns());
  return trace.program(name);
}

Program inertia_factor_inverse(const KinematicTree& tree, const Program& factor, const std::string& name) {
  ProgramTrace trace;
  const GivenFactor f(trace, tree, factor);
  const SquareMatrix inverse_L = inverse_of(trace, f);
  SquareMatrix inverse(f.size());
  for (int i = 0; i < f.size(); ++i) {
    enter(trace, f.coordinates[at(i)], "inverse of H: row");
    for (int j = 0; j <= i; ++j) {
      Expression sum;
      for (int k = 0; k < f.size(); ++k) sum += inverse_L(i, k) * inverse_L(j, k);
      const Label label = coordinates("Hinv", f.coordinates[at(i)].short_name, f.coordinates[at(j)].short_name);
      inverse(i, j) = inverse(j, i) = described(label, sum);
    }
  }
  trace.output("inverse", Role::inertia_matrix, f.size(), f.size(), inverse.columns());
  return trace.program(name);
}

symbolic::SolvedColumns inertia_factor_inverse_L_in_columns(
    const KinematicTree& tree,
    const Program& factor,
    const std::string& name) {
  return inverse_in_columns(tree, factor, name, true);
}

symbolic::SolvedColumns inertia_factor_inverse_in_columns(
    const KinematicTree& tree,
    const Program& factor,
    const std::string& name) {
  return inverse_in_columns(tree, factor, name, false);
}

}  // namespace robcogen::algorithm
