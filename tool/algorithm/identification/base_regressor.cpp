// The parameters of a link that its motions do not reveal move to its parent, as if the link were fixed to it. So the
// base parameters follow from the leaves to the base, and each column of the regressor is that of a single parameter.
#include "algorithm/identification/base_regressor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algorithm/identification/identifiable.h"
#include "algorithm/kinematics/joint_poses.h"
#include "algorithm/spatial/named.h"
#include "symbolic/interpret.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// The exact magnitude of a coefficient that documents would write as a decimal.
Expression coefficient(Graph& graph, double value) {
  return graph.constant(*Number::parse(print_double(std::abs(value))));
}

// Takes the base parameters of a link out of its numbers; the rest is not felt.
std::vector<Expression> take(Graph& graph, const std::vector<Combination>& combinations, InertialNumbers& numbers) {
  std::vector<Expression> taken, others;
  for (const Combination& c : combinations) {
    Expression rest;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (c.coefficients[k] == 0 || k == at(c.parameter)) continue;
      const Expression term = coefficient(graph, c.coefficients[k]) * numbers[k];
      rest += c.coefficients[k] < 0 ? -term : term;
    }
    taken.push_back(numbers[at(c.parameter)] + rest);
    others.push_back(rest);
  }
  for (std::size_t r = 0; r < combinations.size(); ++r) numbers[at(combinations[r].parameter)] = -others[r];
  return taken;
}

// The coefficients of each base parameter, for a document without parameters or with these values of its parameters.
std::vector<std::vector<double>> coefficients(const Program& program, const std::vector<double>& values) {
  const auto inputs = static_cast<std::size_t>(program.inputs.back().elements.size());
  std::vector<std::vector<double>> rows(at(program.outputs.front().rows), std::vector<double>(inputs));
  for (std::size_t k = 0; k < inputs; ++k) {
    std::vector<double> unit(inputs);
    unit[k] = 1;
    symbolic::Arrays<double> arrays = {{program.inputs.back().name, unit}};
    if (!values.empty()) arrays["parameters"] = values;
    const std::vector<double> column = symbolic::interpret(program, arrays).at(program.outputs.front().name);
    for (std::size_t r = 0; r < rows.size(); ++r) rows[r][k] = column[r];
  }
  return rows;
}

// Entries that are rounding noise compared with the others of their kind are dropped.
constexpr double kRoundingNoise = 1e-12;

// A sum as text: `2 a - b`. A coefficient that depends on the document's parameters is left open.
std::string sum_of(
    const std::vector<std::string>& names,
    const std::vector<double>& row,
    const std::vector<double>& other) {
  std::string text;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const bool varies = std::abs(row[k] - other[k]) > kRoundingNoise;
    if (std::abs(row[k]) < kRoundingNoise && !varies) continue;
    const bool is_minus = !varies && row[k] < 0;
    if (!text.empty()) text += is_minus ? " - " : " + ";
    if (text.empty() && is_minus) text += "-";
    const double size = std::abs(row[k]);
    if (varies)
      text += "(...) ";
    else if (std::abs(size - 1) > kRoundingNoise)
      text += fmt::format("{:.6g} ", size);
    text += names[k];
  }
  return text;
}

}  // namespace

Program base_parameters(const model::KinematicTree& tree, const std::string& name, Loads loads) {
  Trace trace(tree);
  const std::vector<Expression> given =
      trace.quantity_input("inertial_parameters", Role::value, inertial_parameter_quantities(tree));
  const std::vector<Pose> at_rest = poses_at_rest(trace);
  const auto first = at(first_moving_link(tree));
  const std::vector<std::string> names = inertial_parameter_names(tree);
  std::vector<InertialNumbers> numbers(tree.links.size());
  for (std::size_t k = 0; k < given.size(); ++k)
    numbers[first + k / kParametersOfLink][k % kParametersOfLink] = given[k];
  for (InertialNumbers& of_link : numbers) of_link = inertial_numbers(mass_properties(of_link), Moments::of_mass);
  const auto combinations = identifiable_combinations(tree, loads);
  std::vector<std::vector<Expression>> by_link(tree.links.size());
  std::vector<int> from_leaves = tree.topological();
  std::reverse(from_leaves.begin(), from_leaves.end());
  const auto take_from = [&](std::size_t link) {
    if (tree.links[link].is_repeated) return;
    const std::string& of = tree.links[link].name;
    trace.section(of, "link ", ": base parameters");
    by_link[link] = take(trace.graph, combinations[link], numbers[link]);
    for (std::size_t r = 0; r < by_link[link].size(); ++r)
      described("beta" + std::to_string(r + 1), of, by_link[link][r]);
  };
  for (const int j : from_leaves) {
    const model::Joint& joint = tree.joints[at(j)];
    take_from(at(joint.child));
    if (at(joint.parent) < first) continue;
    const InertialNumbers left = inertial_numbers(
        to_parent(at_rest[at(j)], mass_properties(numbers[at(joint.child)], Moments::of_mass)), Moments::of_mass);
    for (std::size_t k = 0; k < left.size(); ++k) numbers[at(joint.parent)][k] += left[k];
  }
  if (tree.floating_base) take_from(0);
  std::vector<Expression> beta;
  for (const std::vector<Expression>& of_link : by_link) beta.insert(beta.end(), of_link.begin(), of_link.end());
  trace.output("beta", Role::value, beta);
  return trace.program(name);
}

std::vector<std::string> base_parameter_names(const model::KinematicTree& tree, Loads loads) {
  const Program program = base_parameters(tree, "base_parameters", loads);
  std::vector<double> values = parameter_values(tree);
  const auto rows = coefficients(program, values);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.1 + 0.05 / static_cast<double>(2 + i);
  const auto others = coefficients(program, values);
  const std::vector<std::string> names = inertial_parameter_names(tree);
  std::vector<std::string> result;
  for (std::size_t r = 0; r < rows.size(); ++r) result.push_back(sum_of(names, rows[r], others[r]));
  return result;
}

Program base_regressor(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative) {
  Trace trace(tree);
  const std::vector<LinkColumns> links = regressor_columns(trace, loads, representative, Moments::of_mass);
  const auto combinations = identifiable_combinations(tree, loads);
  std::vector<RegressorColumn> columns;
  for (std::size_t link = 0; link < at(tree.link_count()); ++link)
    for (const Combination& c : combinations[link]) columns.push_back(links[link][at(c.parameter)]);
  const int rows = tree.dof() + (tree.floating_base ? 6 : 0);
  trace.output("Y", Role::matrix, rows, static_cast<int>(columns.size()), flat_by_coordinate(trace, columns));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
