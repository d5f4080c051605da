// Functions for identification and adaptive control: regressors, and the parameters that they multiply.
#include "algorithm/catalogue/groups.h"
#include "algorithm/catalogue/overloads.h"
#include "algorithm/identification/base_regressor.h"
#include "algorithm/identification/drive_regressor.h"
#include "algorithm/identification/regressor.h"

namespace robcogen::algorithm {

using model::KinematicTree;

namespace {

const char* const kParameters =
    "Ten per moving link, in link axes about its origin: mass m, first moment hx hy hz (mass times centre of mass), "
    "moments of inertia Ixx Iyy Izz, products Ixy Ixz Iyz of positive sign.";

std::string columns_of(const std::string& function) {
  return function + "_columns lists the columns.";
}

void add_rows(std::vector<std::string>& summary, const KinematicTree& tree) {
  if (tree.floating_base)
    summary.push_back(
        "(6 + n) rows: those of the base wrench first, in base coordinates, moment first. The motion of the base is an "
        "argument, as in inverse_dynamics_fully_actuated.");
}

RobotFunction function(
    const std::string& group,
    symbolic::Program program,
    std::vector<std::string> summary,
    std::vector<std::string> labels = {}) {
  RobotFunction f{group, "", program.name, std::move(summary), {}, {}, std::move(program)};
  f.labels = std::move(labels);
  return f;
}

// Adds the labels of columns to all overloads of a function.
void add_labels(std::vector<RobotFunction>& list, const std::string& name, const std::vector<std::string>& labels) {
  for (RobotFunction& f : list)
    if (f.name == name) f.labels = labels;
}

}  // namespace

std::vector<RobotFunction> regressor_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const std::string group = "regressor";
  std::vector<std::string> summary = {
      "Regressor Y of inverse dynamics: Y times inertial_parameters() gives the joint forces, without those of drives "
      "(Khalil and Dombre 2002, ch. 12).",
      columns_of("regressor")};
  add_rows(summary, tree);
  std::vector<RobotFunction> list;
  add_overloads(
      list, tree, group, "regressor", summary,
      [&](const std::string& kernel, Loads loads) {
        return regressor(tree, kernel, loads, choices.representative_of_model());
      },
      false);
  add_labels(list, "regressor", inertial_parameter_names(tree));
  list.push_back(function(
      group, inertial_parameters(tree, "inertial_parameters"),
      {"The inertial parameters of the document (kg, kg m, kg m^2), which the columns of regressor multiply.",
       kParameters}));
  summary = {
      "Regressor of drives: Y times drive_parameters() gives the joint forces of drives.",
      columns_of("drive_regressor") +
          " For each joint: inertia that only this joint moves, damping, friction, spring stiffness, constant force. "
          "For each rotor on a moving link: inertia times ratio."};
  add_rows(summary, tree);
  list.push_back(function(group, drive_regressor(tree, "drive_regressor"), summary, drive_parameter_names(tree)));
  list.push_back(function(
      group, drive_parameters(tree, "drive_parameters"),
      {"The parameters of the document's drives, which the columns of drive_regressor multiply.",
       tree.uses_passive_forces ? "Inverse dynamics includes all of them."
                                : "Inverse dynamics does not include damping, friction and springs."}));
  return list;
}

namespace {

// The base parameters under these loads, and their regressor.
void add_base_parameters(
    std::vector<RobotFunction>& list,
    const KinematicTree& tree,
    const std::string& suffix,
    Loads loads,
    const std::string& of_gravity,
    const RepresentativeLinks& representative) {
  const std::string group = "base_regressor", regressor = group + suffix, parameters = "base_parameters" + suffix;
  std::vector<std::string> summary = {
      "Regressor Y of base parameters, the combinations of inertial parameters that forces depend on: Y times " +
          parameters +
          "(inertial_parameters) gives the joint forces, without those of drives (Khalil and Dombre 2002, sec. 9.4; "
          "Wensing, Niemeyer and Slotine 2017).",
      columns_of(regressor)};
  add_rows(summary, tree);
  summary.push_back(of_gravity);
  if (!tree.couplings.empty())
    summary.emplace_back("The base parameters are computed as if no joints were coupled: some may be dependent.");
  list.push_back(function(
      group, base_regressor(tree, regressor, loads, representative), summary, base_parameter_names(tree, loads)));
  list.push_back(function(
      group, base_parameters(tree, parameters, loads),
      {"Base parameters, which the columns of " + regressor + " multiply, from inertial parameters.", kParameters}));
}

}  // namespace

std::vector<RobotFunction> base_regressor_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const RepresentativeLinks& representative = choices.representative_of_model();
  std::vector<RobotFunction> list;
  if (tree.floating_base) {
    add_base_parameters(list, tree, "", Loads::gravity, "`gravity` (m/s^2) is in base coordinates.", representative);
    return list;
  }
  add_base_parameters(
      list, tree, "", Loads::standard_gravity,
      "Gravity is (0, 0, -9.81) m/s^2 in base coordinates: under any other gravity, forces may depend on more "
      "parameters, those of base_regressor_any_gravity.",
      representative);
  add_base_parameters(
      list, tree, "_any_gravity", Loads::gravity,
      "`gravity` (m/s^2) is in base coordinates and may have any direction. If all measurements have the same "
      "direction, some parameters may be dependent.",
      representative);
  return list;
}

std::vector<RobotFunction> energy_regressor_functions(const KinematicTree& tree, FormulationChoices& choices) {
  std::vector<std::string> summary = {
      "Regressor Y of the energies (J): Y times the inertial parameters, in the order of the columns of regressor, "
      "gives the kinetic energy (first row) and the potential energy (second row), without those of drives."};
  if (tree.floating_base) summary.emplace_back("`base_velocity` is in base coordinates, angular first.");
  std::vector<RobotFunction> list;
  add_overloads(
      list, tree, "energy_regressor", "energy_regressor", summary,
      [&](const std::string& kernel, Loads loads) {
        return energy_regressor(tree, kernel, loads, choices.representative_of_model());
      },
      false);
  return list;
}

std::vector<RobotFunction> slotine_li_regressor_functions(const KinematicTree& tree, FormulationChoices& choices) {
  std::vector<std::string> summary = {
      "Regressor Y of a reference motion, for adaptive control: Y times the inertial parameters, in the order of the "
      "columns of regressor, is H qdd_r + C qd_r + gravity forces, with the Coriolis matrix C of coriolis_matrix, for "
      "which dH/dt - 2 C is skew symmetric (Slotine and Li 1987; Niemeyer and Slotine 1991)."};
  if (tree.floating_base)
    summary.emplace_back(
        "(6 + n) rows: those of the base wrench first, moment first; the base also has a reference velocity and the "
        "rate of its coordinates. All are in base coordinates, angular first.");
  std::vector<RobotFunction> list;
  add_overloads(
      list, tree, "slotine_li_regressor", "slotine_li_regressor", summary,
      [&](const std::string& kernel, Loads loads) {
        return slotine_li_regressor(tree, kernel, loads, choices.representative_of_model());
      },
      false);
  return list;
}

}  // namespace robcogen::algorithm
