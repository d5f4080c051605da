// Derivatives of the dynamics.
#include "algorithm/catalogue/groups.h"
#include "algorithm/catalogue/overloads.h"
#include "algorithm/catalogue/sizes.h"

namespace robcogen::algorithm {

using model::KinematicTree;

namespace {

// Adds the end of a summary: the meaning of the rows, and of the columns of the base.
void add_base(std::vector<std::string>& summary, const std::string& rows, const std::string& columns) {
  summary.push_back(
      "(6 + n) rows: those of " + rows + " first. All quantities of the base are in base coordinates, angular first.");
  summary.push_back(
      "Columns of the base: by " + columns +
      "a rotation of the base about its own axes (d_base_rotation); gravity is fixed in the world and changes in base "
      "coordinates.");
}

const char* const kColumns =
    "their partial derivatives: a column for each joint's position (d_q), velocity (d_qd) and acceleration (d_qdd";

void add_gravity_forces_derivative(
    std::vector<RobotFunction>& list,
    const KinematicTree& tree,
    FormulationChoices& choices) {
  const Formulation formulation = choices.cheaper_for([&](const Formulation& f) {
    return gravity_forces_derivative(tree, "gravity_forces_derivative", Loads::gravity, f);
  });
  const bool is_symmetric = tree.spherical_joints().empty();
  std::vector<std::string> summary = {
      "Partial derivatives of the generalised forces that hold the robot at rest against gravity: a column for each "
      "joint's position" +
      std::string(
          tree.floating_base ? " (d_q)."
          : is_symmetric     ? "; symmetric."
                             : ".")};
  if (tree.floating_base) add_base(summary, "the base wrench", "");
  add_overloads(
      list, tree, "inverse_dynamics_derivatives", "gravity_forces_derivative", summary,
      [&](const std::string& kernel, Loads loads) {
        return gravity_forces_derivative(tree, kernel, loads, formulation);
      },
      false);
  add_method(list, "gravity_forces_derivative", description(tree, formulation.frames));
}

}  // namespace

std::vector<RobotFunction> inverse_dynamics_derivatives_functions(
    const KinematicTree& tree,
    FormulationChoices& choices) {
  const Formulation& formulation = choices.inverse_dynamics_derivatives();
  const std::string forces = "Joint forces tau (N m, N) for joint accelerations qdd, ";
  std::vector<RobotFunction> list;
  const auto add = [&](const std::string& name, const std::vector<std::string>& summary, const auto& trace) {
    add_overloads(
        list, tree, "inverse_dynamics_derivatives", name, summary,
        [&](const std::string& kernel, Loads loads) { return trace(tree, kernel, loads, formulation); });
    add_wrenches_remark(list);
    add_method(list, name, description(tree, formulation.frames));
  };
  if (!tree.floating_base) {
    add("inverse_dynamics_derivatives", {forces + "and " + kColumns + ", the joint-space inertia matrix)."},
        inverse_dynamics_derivatives);
  } else {
    if (!tree.inertia_defects.locked_base) {
      std::vector<std::string> summary = {
          forces + "the spatial acceleration of the unactuated base, and " + kColumns + ")."};
      add_base(summary, "the base acceleration", "the base's velocity (d_base_velocity), and ");
      add("inverse_dynamics_derivatives", summary, unactuated_base_inverse_dynamics_derivatives);
      if (solves_for_base_in_columns(tree))
        for (RobotFunction& f : list) {
          f.solved = unactuated_base_inverse_dynamics_derivatives_in_columns(
              tree, f.program.name, loads_of(f.program), formulation);
          f.solved->is_long = are_long_solutions(operations_of_base_solutions(tree));
        }
    }
    std::vector<std::string> summary = {forces + "the wrench on the base, and " + kColumns + ")."};
    add_base(
        summary, "the base wrench",
        "the base's velocity (d_base_velocity), its spatial acceleration (d_base_acceleration), and ");
    add("inverse_dynamics_fully_actuated_derivatives", summary, inverse_dynamics_derivatives);
  }
  add_gravity_forces_derivative(list, tree, choices);
  return list;
}

std::vector<RobotFunction> inverse_dynamics_gradient_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const Formulation& formulation = choices.newton_euler();
  const std::string name = "inverse_dynamics_gradient";
  std::vector<std::string> summary = {
      tree.floating_base
          ? "Joint forces tau (N m, N) and the wrench on the base for joint and base accelerations, and the gradient "
            "of `weights` times these forces, weights of the base wrench first."
          : "Joint forces tau (N m, N) for joint accelerations qdd, and the gradient of `weights` times tau.",
      "The gradient is the transpose of the derivatives times `weights`, computed by reverse mode at a small multiple "
      "of the cost of inverse dynamics."};
  std::vector<RobotFunction> list;
  add_overloads(list, tree, name, name, summary, [&](const std::string& kernel, Loads loads) {
    return inverse_dynamics_gradient(tree, kernel, loads, formulation);
  });
  add_wrenches_remark(list);
  add_method(list, name, description(tree, formulation.frames));
  return list;
}

namespace {

// Each `d_x_y` is the derivative of `d_x` by y.
std::vector<symbolic::DerivativeBlock> second_blocks(const symbolic::Program& program) {
  std::vector<symbolic::DerivativeBlock> blocks;
  const auto index = [&](std::size_t k) { return static_cast<int>(k); };
  for (std::size_t place = 0; place < program.outputs.size(); ++place)
    for (std::size_t of = 0; of < place; ++of)
      for (const symbolic::InputArray& input : program.inputs)
        if (program.outputs[place].name == program.outputs[of].name + "_" + input.name)
          blocks.push_back({index(of), input.name, index(place)});
  return blocks;
}

}  // namespace

std::vector<RobotFunction> inverse_dynamics_second_derivatives_functions(
    const KinematicTree& tree,
    FormulationChoices& choices) {
  const Formulation& formulation = choices.newton_euler();
  const std::string name = "inverse_dynamics_second_derivatives";
  std::vector<std::string> summary = {
      "The gradient of `weights` times the joint forces tau (N m, N), and its derivatives: the terms of inverse "
      "dynamics in second-order methods of optimal control.",
      "Rows belong to the first input in a name, columns to the second; " +
          std::string(tree.spherical_joints().empty() ? "d_q_q and d_qd_qd are" : "d_qd_qd is") +
          " symmetric. Accelerations enter linearly: all other blocks are zero."};
  if (tree.floating_base)
    summary.emplace_back(
        "`weights` are in the order of the base wrench, then of the joints. All quantities of the base are in base "
        "coordinates, angular first.");
  std::vector<RobotFunction> list;
  add_overloads(list, tree, name, name, summary, [&](const std::string& kernel, Loads loads) {
    return inverse_dynamics_second_derivatives(tree, kernel, loads, formulation);
  });
  for (RobotFunction& f : list) f.derivatives = second_blocks(f.program);
  add_wrenches_remark(list);
  add_method(list, name, description(tree, formulation.frames));
  return list;
}

std::vector<RobotFunction> forward_dynamics_derivatives_functions(
    const KinematicTree& tree,
    FormulationChoices& choices) {
  const Formulation& formulation = choices.inverse_dynamics_derivatives();
  const std::string name = "forward_dynamics_derivatives";
  std::vector<std::string> summary = {
      "Joint accelerations qdd (rad/s^2, m/s^2) from joint forces tau, and their partial derivatives: a column for "
      "each joint's position (d_q), velocity (d_qd) and force (d_tau: of the inverse of the joint-space inertia "
      "matrix)."};
  if (tree.floating_base) add_base(summary, "the base acceleration", "the base's velocity (d_base_velocity), and ");
  std::vector<RobotFunction> list;
  add_overloads(list, tree, name, name, summary, [&](const std::string& kernel, Loads loads) {
    return forward_dynamics_derivatives(tree, kernel, loads, formulation);
  });
  if (solves_in_columns(tree))
    for (RobotFunction& f : list) {
      f.solved = forward_dynamics_derivatives_in_columns(tree, f.program.name, loads_of(f.program), formulation);
      f.solved->is_long = are_long_solutions(operations_of_solutions(tree));
    }
  add_wrenches_remark(list);
  add_method(list, name, description(tree, formulation.frames));
  return list;
}

}  // namespace robcogen::algorithm
