#include "algorithm/dynamics/drive_derivatives.h"

#include <set>

#include "algorithm/dynamics/drives.h"
#include "algorithm/spatial/couplings.h"
#include "symbolic/derivative.h"

namespace robcogen::algorithm {
namespace {

std::size_t rows_of_base(const Trace& trace) {
  return trace.tree.floating_base ? 6 : 0;
}

// Adds the derivatives of the force of a row by the position and velocity of a column.
void add_passive(
    const Expression& force,
    std::size_t row,
    const StateInputs& in,
    std::size_t column,
    ForceDerivatives& d) {
  d.q[column][row] += symbolic::derivative(force, in.q[column]);
  d.qd[column][row] += symbolic::derivative(force, in.qd[column]);
}

// By joint: the joints on whose motion its passive forces depend: itself, and those on its tendons.
std::vector<std::set<std::size_t>> joints_of_forces(const model::KinematicTree& tree) {
  std::vector<std::set<std::size_t>> joints(tree.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) joints[j].insert(j);
  for (const model::Tendon& tendon : tree.tendons)
    for (const model::Tendon::Term& pulled : tendon.terms)
      for (const model::Tendon::Term& moved : tendon.terms) joints[at(pulled.joint)].insert(at(moved.joint));
  return joints;
}

// Reduces derivatives from joints to coordinates.
void reduce(Trace& trace, ForceDerivatives& d) {
  const int base = static_cast<int>(rows_of_base(trace));
  for (Columns* columns : {&d.q, &d.qd, &d.qdd}) *columns = by_coordinate(trace, *columns, base);
  for (Columns* columns : {&d.base_rotation, &d.base_velocity, &d.base_acceleration})
    *columns = rows_by_coordinate(trace, *columns, base);
}

// The inputs of coordinates, in their order.
StateInputs independent_inputs(const Trace& trace, const StateInputs& in) {
  const std::vector<int> coordinates = trace.tree.coordinates();
  StateInputs independent = in;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    independent.q[k] = in.q[at(coordinates[k])];
    independent.qd[k] = in.qd[at(coordinates[k])];
  }
  return independent;
}

}  // namespace

void add_drives(Trace& trace, const StateInputs& in, ForceDerivatives& d, PassiveForces of_drives) {
  const std::size_t base = rows_of_base(trace);
  const std::vector<Expression> passive =
      of_drives == PassiveForces::included ? passive_forces(trace, in.q, in.qd) : std::vector<Expression>(in.qd.size());
  const bool is_coupled = !trace.tree.couplings.empty();
  const std::vector<std::set<std::size_t>> joints = joints_of_forces(trace.tree);
  for (std::size_t j = 0; j < passive.size(); ++j) {
    if (!is_coupled)
      for (const std::size_t column : joints[j]) add_passive(passive[j], base + j, in, column, d);
    d.qdd[j][base + j] += drive_inertia(trace, static_cast<int>(j));
  }
  if (!is_coupled) return;
  trace.section("coupled", "derivatives of coupled joints");
  reduce(trace, d);
  const StateInputs independent = independent_inputs(trace, in);
  const std::vector<Expression> reduced = by_coordinate(trace, passive);
  for (std::size_t row = 0; row < reduced.size(); ++row)
    for (std::size_t column = 0; column < reduced.size(); ++column)
      add_passive(reduced[row], base + row, independent, column, d);
}

}  // namespace robcogen::algorithm
