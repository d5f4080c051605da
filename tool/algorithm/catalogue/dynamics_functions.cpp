#include <algorithm>

#include "algorithm/catalogue/groups.h"
#include "algorithm/catalogue/overloads.h"

namespace robcogen::algorithm {

using model::KinematicTree;

namespace {

bool uses_passive_forces(const KinematicTree& tree) {
  return tree.uses_passive_forces && std::any_of(tree.joints.begin(), tree.joints.end(), [](const model::Joint& joint) {
           return joint.drive.is_passive();
         });
}

}  // namespace

std::vector<RobotFunction> inverse_dynamics_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const Formulation& formulation = choices.newton_euler();
  std::vector<RobotFunction> list;
  const std::string group = "inverse_dynamics";
  if (!tree.floating_base) {
    add_overloads(
        list, tree, group, "inverse_dynamics",
        {"Joint forces tau (N m, N) for joint accelerations qdd: recursive Newton-Euler (Featherstone 2008, ch. 5)."},
        [&](const std::string& kernel, Loads loads) { return newton_euler(tree, kernel, loads, formulation); });
    add_method(list, "inverse_dynamics", description(tree, formulation.frames));
    add_loop_forces(list, tree, choices);
    return list;
  }
  // The function divides by the inertia of the robot as one body.
  const bool has_free_base = !tree.inertia_defects.locked_base;
  if (has_free_base)
    add_overloads(
        list, tree, group, "inverse_dynamics",
        {"Joint forces tau (N m, N) for joint accelerations qdd, and the spatial acceleration of the unactuated base "
         "(Featherstone 2008, sec. 9.4).",
         "`base_velocity` and `base_acceleration` are in base coordinates, angular first."},
        [&](const std::string& kernel, Loads loads) {
          return unactuated_base_inverse_dynamics(tree, kernel, loads, choices.unactuated_base());
        });
  add_overloads(
      list, tree, group, "inverse_dynamics_fully_actuated",
      {"Joint forces tau (N m, N) and the wrench on the base for joint and base accelerations: recursive Newton-Euler "
       "(Featherstone 2008, ch. 5).",
       "`base_velocity`, `base_acceleration` (spatial, gravity not included) and `base_wrench` are in base "
       "coordinates, angular first."},
      [&](const std::string& kernel, Loads loads) { return newton_euler(tree, kernel, loads, formulation); });
  if (has_free_base) add_method(list, "inverse_dynamics", description(tree, choices.unactuated_base().frames));
  add_method(list, "inverse_dynamics_fully_actuated", description(tree, formulation.frames));
  add_loop_forces(list, tree, choices);
  return list;
}

std::vector<RobotFunction> bias_forces_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const Formulation& formulation = choices.newton_euler();
  const Formulation gravity = choices.cheaper_for(
      [&](const Formulation& f) { return gravity_forces(tree, "gravity_forces", Loads::gravity, f); });
  std::vector<RobotFunction> list;
  const std::string group = "bias_forces";
  const std::string base =
      tree.floating_base ? "`base_velocity` and `base_wrench` are in base coordinates, angular first." : "";
  const auto summary = [&](const std::string& what) {
    std::vector<std::string> lines{what};
    if (!base.empty()) lines.push_back(base);
    return lines;
  };
  add_overloads(
      list, tree, group, "bias_forces",
      summary(
          "Generalised forces at zero acceleration: Coriolis, centrifugal, gravity, " +
          std::string(uses_passive_forces(tree) ? "passive forces of drives, " : "") + "minus external forces."),
      [&](const std::string& kernel, Loads loads) { return bias_forces(tree, kernel, loads, formulation); });
  add_overloads(
      list, tree, group, "gravity_forces", summary("Generalised forces that hold the robot at rest against gravity."),
      [&](const std::string& kernel, Loads loads) { return gravity_forces(tree, kernel, loads, gravity); }, false);
  list.push_back(
      {group,
       "",
       "coriolis_forces",
       summary("Generalised forces due to velocities: bias forces without gravity."),
       {},
       {},
       coriolis_forces(tree, "coriolis_forces", formulation)});
  for (const char* name : {"bias_forces", "coriolis_forces"})
    add_method(list, name, description(tree, formulation.frames));
  add_method(list, "gravity_forces", description(tree, gravity.frames));
  return list;
}

std::vector<RobotFunction> passive_forces_functions(const KinematicTree& tree, FormulationChoices&) {
  const std::string use = tree.uses_passive_forces ? "Inverse dynamics and bias forces include them."
                                                   : "Inverse dynamics and bias forces do not include them.";
  std::vector<RobotFunction> list = {
      {"passive_forces",
       "",
       "passive_forces",
       {"Joint forces that overcome damping, friction and springs of the drives: tau = b qd + f s(qd) + k (q - q0), "
        "with s(qd) = qd / sqrt(qd^2 + v^2), which is the sign of qd if v is zero. " +
        use},
       {},
       {},
       passive_forces(tree, "passive_forces")}};
  if (tree.has_rotors())
    list.push_back(
        {"passive_forces",
         "",
         "motor_torques",
         {"Torques (N m) at the motor shafts for joint forces tau: tau divided by the ratio of the rotor, without gear "
          "losses; tau itself for a joint without rotor. With tau of inverse dynamics, they are the total torques of "
          "the motors: for their rotors, for passive forces, and for the robot."},
         {},
         {},
         motor_torques(tree, "motor_torques")});
  return list;
}

std::vector<RobotFunction> forward_dynamics_functions(const KinematicTree& tree, FormulationChoices& choices) {
  std::vector<RobotFunction> list;
  const ForwardDynamicsChoice& choice = choices.forward_dynamics();
  const bool by_matrix = choice.method == ForwardDynamicsMethod::inertia_matrix;
  const std::string method = by_matrix ? "Method: bias forces, and elimination in the joint-space inertia matrix."
                                       : "Method: articulated-body algorithm.";
  const std::string source = by_matrix ? "(Featherstone 2008, ch. 6)" : "(Featherstone 2008, ch. 7)";
  std::vector<std::string> summary{"Joint accelerations qdd (rad/s^2, m/s^2) from joint forces tau " + source + "."};
  if (tree.floating_base)
    summary.push_back("`base_velocity` and `base_acceleration` (spatial) are in base coordinates, angular first.");
  add_overloads(
      list, tree, "forward_dynamics", "forward_dynamics", summary,
      [&](const std::string& kernel, Loads loads) { return forward_dynamics(tree, kernel, loads, choice); });
  add_method(list, "forward_dynamics", description(tree, choice.formulation.frames));
  for (RobotFunction& f : list) f.method = method + (f.method.empty() ? "" : " " + f.method);
  add_loop_constrained_dynamics(list, tree, choices);
  return list;
}

std::vector<RobotFunction> joint_space_inertia_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const Formulation& formulation = choices.inertia();
  std::vector<RobotFunction> list = {
      {"joint_space_inertia",
       "",
       "joint_space_inertia",
       {"Joint-space inertia matrix H, symmetric, structural zeros literal: composite rigid bodies (Featherstone 2008, "
        "ch. 6).",
        tree.floating_base ? "(6 + n) x (6 + n): base rows first, in base coordinates, angular first."
                           : "n x n, joints in the order of the model."},
       {},
       {},
       joint_space_inertia(tree, "joint_space_inertia", formulation)}};
  add_method(list, "joint_space_inertia", description(tree, formulation.frames));
  return list;
}

std::vector<RobotFunction> joint_space_inertia_factor_functions(
    const KinematicTree& tree,
    FormulationChoices& choices) {
  const Formulation& formulation = choices.inertia();
  const std::string group = "joint_space_inertia_factor";
  const symbolic::Program factor = joint_space_inertia_factor(tree, group, formulation);
  const auto of_factor = [&](const std::string& name, std::vector<std::string> summary, const auto& build) {
    return RobotFunction{
        group, "inertia_factor", name, std::move(summary), {}, {}, build(tree, factor, "inertia_factor_" + name)};
  };
  const std::string rows = tree.floating_base ? "(6 + n) rows: base first, in base coordinates, angular first."
                                              : "n rows, joints in the order of the model.";
  std::vector<RobotFunction> list = {
      {group,
       "",
       group,
       {"Factor L of the joint-space inertia matrix H = L^T L: zero except on the diagonal and at the ancestors of "
        "each coordinate; and the reciprocals of its diagonal (Featherstone 2008, sec. 6.5).",
        rows},
       {},
       {},
       factor},
      of_factor(
          "solve", {"y = H^-1 x, by substitution along the ancestors of each coordinate.", rows}, inertia_factor_solve),
      of_factor("inverse", {"H^-1, symmetric; structural zeros are literal.", rows}, inertia_factor_inverse),
      of_factor("inverse_L", {"L^-1, with the zeros of L.", rows}, inertia_factor_inverse_L)};
  add_method(list, group, description(tree, formulation.frames));
  return list;
}

std::vector<RobotFunction> coriolis_matrix_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const Formulation formulation =
      choices.cheaper_for([&](const Formulation& f) { return coriolis_matrix(tree, "coriolis_matrix", f); });
  std::vector<RobotFunction> list = {
      {"coriolis_matrix",
       "",
       "coriolis_matrix",
       {"Coriolis matrix C: C times the velocity gives the generalised forces due to velocities, and dH/dt - 2 C "
        "is skew symmetric (Niemeyer and Slotine 1991; Echeandia and Wensing 2021).",
        tree.floating_base
            ? "(6 + n) x (6 + n), as the joint-space inertia matrix H: for the velocity (base twist, qd), "
              "in base coordinates, angular first."
            : "n x n, joints in the order of the model."},
       {},
       {},
       coriolis_matrix(tree, "coriolis_matrix", formulation)}};
  add_method(list, "coriolis_matrix", description(tree, formulation.frames));
  return list;
}

std::vector<RobotFunction> centroidal_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const RepresentativeLinks& representative = choices.representative_of_model();
  const std::string moves = tree.floating_base ? "the robot" : "the moving links";
  const std::string columns =
      tree.floating_base ? "(6 + n) columns: for the velocity (base twist in base coordinates, angular first; qd)."
                         : "n columns, joints in the order of the model.";
  const auto function = [](const std::string& name, std::vector<std::string> summary, symbolic::Program program) {
    return RobotFunction{"centroidal", "", name, std::move(summary), {}, {}, std::move(program)};
  };
  std::vector<RobotFunction> list = {
      function(
          "center_of_mass", {"Centre of mass of " + moves + " (m), in base coordinates."},
          center_of_mass(tree, "center_of_mass", representative)),
      function(
          "center_of_mass_jacobian",
          {"Velocity (m/s) of the centre of mass of " + moves + ", in base axes: 3 rows.", columns},
          center_of_mass_jacobian(tree, "center_of_mass_jacobian", representative)),
      function(
          "centroidal_momentum_matrix",
          {"Spatial momentum of " + moves +
               " about the centre of mass, in base axes: 3 rows of angular momentum (N m s), 3 of linear momentum (N "
               "s) (Orin, Goswami, Lee 2013).",
           columns},
          centroidal_momentum_matrix(tree, "centroidal_momentum_matrix", representative))};
  // For robots without parameters the mass is a constant.
  if (!tree.parameters.empty())
    list.push_back(function("total_mass", {"Mass of " + moves + " (kg)."}, total_mass(tree, "total_mass")));
  return list;
}

std::vector<RobotFunction> centroidal_bias_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const std::string velocity = tree.floating_base ? "(spatial base acceleration, qdd)" : "qdd";
  return {
      {"centroidal_bias",
       "",
       "centroidal_momentum_bias",
       {"Bias of the centroidal momentum: the rate of angular (N m) and linear (N) momentum minus the centroidal "
        "momentum matrix times " +
            velocity + ", in an inertial frame and in base axes, angular first (Wensing and Orin 2016).",
        "The rate of the momentum equals the external moment about the centre of mass, and the external force."},
       {},
       {},
       centroidal_momentum_bias(tree, "centroidal_momentum_bias", choices.representative_of_model())}};
}

std::vector<RobotFunction> energy_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const Formulation formulation =
      choices.cheaper_for([&](const Formulation& f) { return kinetic_energy(tree, "kinetic_energy", f); });
  std::vector<RobotFunction> list;
  std::vector<std::string> summary{"Kinetic energy (J), summed over the links."};
  if (tree.floating_base) summary.push_back("`base_velocity` is in base coordinates, angular first.");
  list.push_back(
      {"energy", "", "kinetic_energy", summary, {}, {}, kinetic_energy(tree, "kinetic_energy", formulation)});
  add_method(list, "kinetic_energy", description(tree, formulation.frames));
  add_overloads(
      list, tree, "energy", "potential_energy",
      {std::string("Potential energy (J) of ") + (tree.floating_base ? "the robot" : "the moving links") +
       ", zero where their centre of mass is at the base origin."},
      [&](const std::string& kernel, Loads loads) {
        return potential_energy(choices.model(), kernel, loads, choices.representative_of_model());
      },
      false);
  return list;
}

}  // namespace robcogen::algorithm
