#include "algorithm/robot_programs.h"

#include <algorithm>
#include <functional>

#include "algorithm/chain.h"
#include "algorithm/kinematics.h"
#include "algorithm/transform_kinds.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;

using Build = std::function<symbolic::Program(const std::string& kernel, Loads loads)>;

// Says how functions are computed.
void add_method(std::vector<RobotFunction>& list, const std::string& name, const std::string& method) {
  if (method.empty()) return;
  for (RobotFunction& f : list) {
    if (f.name != name) continue;
    f.method = method;
    f.summary.push_back(method);
  }
}

// The overloads of one function. With a floating base gravity is always an argument: it says how the base is oriented.
void add_overloads(
    std::vector<RobotFunction>& list,
    const KinematicTree& tree,
    const std::string& group,
    const std::string& name,
    std::vector<std::string> summary,
    const Build& build,
    bool takes_external = true) {
  const auto add = [&](Loads loads, const std::string& suffix, const std::string& remark) {
    std::vector<std::string> lines = summary;
    lines.push_back(remark);
    const std::string kernel = name + suffix;
    list.push_back({group, "", name, std::move(lines), {}, {}, build(kernel, loads)});
  };
  if (!tree.floating_base) add(Loads::standard_gravity, "", "Gravity is (0, 0, -9.81) m/s^2 in base coordinates.");
  add(Loads::gravity, tree.floating_base ? "" : "_gravity", "`gravity` (m/s^2) is in base coordinates.");
  if (takes_external)
    add(Loads::gravity_and_external, "_external",
        "`gravity` (m/s^2) is in base coordinates; `external` is the wrench on each link, in link coordinates about "
        "the "
        "link's origin.");
}

std::vector<RobotFunction> inverse_dynamics_group(const KinematicTree& tree, Formulations& formulations) {
  const Formulation& formulation = formulations.newton_euler();
  std::vector<RobotFunction> list;
  const std::string group = "inverse_dynamics";
  if (!tree.floating_base) {
    add_overloads(
        list, tree, group, "inverse_dynamics",
        {"Joint forces tau (N m, N) for joint accelerations qdd: recursive Newton-Euler (Featherstone 2008, ch. 5)."},
        [&](const std::string& kernel, Loads loads) { return newton_euler(tree, kernel, loads, formulation); });
    add_method(list, "inverse_dynamics", description(tree, formulation.frames));
    return list;
  }
  add_overloads(
      list, tree, group, "inverse_dynamics",
      {"Joint forces tau (N m, N) for joint accelerations qdd, and the spatial acceleration of the base that nothing "
       "holds (Featherstone 2008, sec. 9.4).",
       "`base_velocity` and `base_acceleration` are in base coordinates, angular first."},
      [&](const std::string& kernel, Loads loads) {
        return unactuated_base_inverse_dynamics(tree, kernel, loads, formulations.unactuated_base());
      });
  add_overloads(
      list, tree, group, "inverse_dynamics_fully_actuated",
      {"Joint forces tau (N m, N) and the wrench on the base for joint and base accelerations: recursive Newton-Euler "
       "(Featherstone 2008, ch. 5).",
       "`base_velocity`, `base_acceleration` (spatial, gravity not included) and `base_wrench` are in base "
       "coordinates, "
       "angular first."},
      [&](const std::string& kernel, Loads loads) { return newton_euler(tree, kernel, loads, formulation); });
  add_method(list, "inverse_dynamics", description(tree, formulations.unactuated_base().frames));
  add_method(list, "inverse_dynamics_fully_actuated", description(tree, formulation.frames));
  return list;
}

std::vector<RobotFunction> bias_forces_group(const KinematicTree& tree, Formulations& formulations) {
  const Formulation& formulation = formulations.newton_euler();
  const Formulation gravity = formulations.cheaper_for(
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
      summary("Generalised forces at zero acceleration: Coriolis, centrifugal, gravity, minus external ones."),
      [&](const std::string& kernel, Loads loads) { return bias_forces(tree, kernel, loads, formulation); });
  add_overloads(
      list, tree, group, "gravity_forces", summary("Generalised forces that hold the robot at rest against gravity."),
      [&](const std::string& kernel, Loads loads) { return gravity_forces(tree, kernel, loads, gravity); }, false);
  list.push_back(
      {group,
       "",
       "coriolis_forces",
       summary("Generalised forces that velocities cause: bias forces without gravity."),
       {},
       {},
       coriolis_forces(tree, "coriolis_forces", formulation)});
  for (const char* name : {"bias_forces", "coriolis_forces"})
    add_method(list, name, description(tree, formulation.frames));
  add_method(list, "gravity_forces", description(tree, gravity.frames));
  return list;
}

std::vector<RobotFunction> forward_dynamics_group(const KinematicTree& tree, Formulations& formulations) {
  std::vector<RobotFunction> list;
  const ForwardDynamicsChoice& choice = formulations.forward_dynamics();
  const bool by_matrix = choice.method == ForwardDynamicsMethod::inertia_matrix;
  const std::string method =
      by_matrix ? "bias forces, and elimination in the joint-space inertia matrix (Featherstone 2008, ch. 6)."
                : "articulated-body algorithm (Featherstone 2008, ch. 7).";
  std::vector<std::string> summary{"Joint accelerations qdd (rad/s^2, m/s^2) from joint forces tau: " + method};
  if (tree.floating_base)
    summary.push_back("`base_velocity` and `base_acceleration` (spatial) are in base coordinates, angular first.");
  add_overloads(
      list, tree, "forward_dynamics", "forward_dynamics", summary,
      [&](const std::string& kernel, Loads loads) { return forward_dynamics(tree, kernel, loads, choice); });
  add_method(list, "forward_dynamics", description(tree, choice.formulation.frames));
  for (RobotFunction& f : list) f.method = "By " + method + (f.method.empty() ? "" : " " + f.method);
  return list;
}

std::vector<RobotFunction> joint_space_inertia_group(const KinematicTree& tree, const Formulation& formulation) {
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

std::vector<RobotFunction> joint_space_inertia_factor_group(const KinematicTree& tree, const Formulation& formulation) {
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
       {"Factor L of the joint-space inertia matrix H = L^T L: zero but for the diagonal and the ancestors of each "
        "coordinate; with the reciprocals of its diagonal (Featherstone 2008, sec. 6.5).",
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

std::vector<RobotFunction> coriolis_matrix_group(const KinematicTree& tree, Formulations& formulations) {
  const Formulation formulation =
      formulations.cheaper_for([&](const Formulation& f) { return coriolis_matrix(tree, "coriolis_matrix", f); });
  std::vector<RobotFunction> list = {
      {"coriolis_matrix",
       "",
       "coriolis_matrix",
       {"Coriolis matrix C: C times the velocity is what velocities cause of the generalised forces, and dH/dt - 2 C "
        "is "
        "skew symmetric (Niemeyer and Slotine 1991; Echeandia and Wensing 2021).",
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

std::vector<RobotFunction> centroidal_group(const KinematicTree& tree, const TypicalLinks& typical) {
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
          center_of_mass(tree, "center_of_mass", typical)),
      function(
          "center_of_mass_jacobian",
          {"Velocity (m/s) of the centre of mass of " + moves + ", in base axes: 3 rows.", columns},
          center_of_mass_jacobian(tree, "center_of_mass_jacobian", typical)),
      function(
          "centroidal_momentum_matrix",
          {"Spatial momentum of " + moves +
               " about their centre of mass, in base axes: 3 rows of angular momentum (N m s), 3 of linear momentum (N "
               "s) "
               "(Orin, Goswami, Lee 2013).",
           columns},
          centroidal_momentum_matrix(tree, "centroidal_momentum_matrix", typical))};
  // A constant of robots without parameters.
  if (!tree.parameters.empty())
    list.push_back(function("total_mass", {"Mass of " + moves + " (kg)."}, total_mass(tree, "total_mass")));
  return list;
}

std::vector<RobotFunction> energy_group(const KinematicTree& tree, Formulations& formulations) {
  const Formulation formulation =
      formulations.cheaper_for([&](const Formulation& f) { return kinetic_energy(tree, "kinetic_energy", f); });
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
        return potential_energy(tree, kernel, loads, formulations.typical_of_model());
      },
      false);
  return list;
}

std::vector<RobotFunction> transforms_group(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  const model::RigidMotions motions = model::motions_of(tree);
  const model::MotionGraph graph(motions);
  std::vector<std::vector<Stretch>> ways;
  for (const model::FramePair& pair : desired.transforms) ways.push_back(chain(tree, graph, pair));
  std::vector<RobotFunction> list;
  for (const TransformKind& kind : transform_kinds()) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const model::FramePair& pair = desired.transforms[i];
      const std::string name = pair.left.name + "_X_" + pair.right.name;
      list.push_back(
          {"transforms",
           "transforms::" + kind.scope,
           name,
           {kind.summary(pair.left.name, pair.right.name)},
           {},
           pair,
           transform_along(tree, ways[i], kind.form, kind.scope + "_" + name)});
    }
  }
  return list;
}

// One function for each desired Jacobian: `fr_base_<letter>_fr_foot`. Programs are called by `prefix` too, where the
// name is one of several scopes.
using BuildBetween = std::function<symbolic::Program(const model::FramePair& frames, const std::string& name)>;

void add_for_jacobians(
    std::vector<RobotFunction>& list,
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const std::string& scope,
    const std::string& letter,
    const std::function<std::string(const std::string& left, const std::string& right)>& summary,
    const BuildBetween& build,
    const std::string& prefix = "") {
  for (const model::FramePair& pair : desired.jacobians) {
    const std::string name = pair.left.name + "_" + letter + "_" + pair.right.name;
    symbolic::Program program = build(pair, prefix + name);
    const bool has_columns = symbolic::is_jacobian(program.outputs.front().role);
    list.push_back(
        {group,
         scope,
         name,
         {summary(pair.left.name, pair.right.name)},
         has_columns ? chain_joints(tree, pair) : std::vector<int>{},
         pair,
         std::move(program)});
  }
}

std::vector<RobotFunction> jacobians_group(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "jacobians", "jacobians", "J",
      [](const std::string& left, const std::string& right) {
        return "Geometric Jacobian: angular velocity of " + right + " and velocity of its origin, with respect to " +
               left + " and in its axes; angular rows first (Siciliano et al. 2009, ch. 3).";
      },
      [&](const model::FramePair& pair, const std::string& name) { return geometric_jacobian(tree, pair, name); });
  return list;
}

std::vector<RobotFunction> jacobian_references_group(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "jacobian_references", "jacobians::in_target", "J",
      [](const std::string& left, const std::string& right) {
        return "Geometric Jacobian: angular velocity of " + right + " and velocity of its origin, with respect to " +
               left + ", in axes of " + right + "; angular rows first.";
      },
      [&](const model::FramePair& pair, const std::string& name) {
        return geometric_jacobian(tree, pair, name, JacobianReference::in_target);
      },
      "in_target_");
  add_for_jacobians(
      list, tree, desired, "jacobian_references", "jacobians::spatial", "J",
      [](const std::string& left, const std::string& right) {
        return "Spatial Jacobian: twist of " + right + " with respect to " + left + ", in coordinates of " + left +
               ": angular velocity, then velocity of the point of " + right + " that is at the origin of " + left +
               "; angular rows first (Featherstone 2008, ch. 2).";
      },
      [&](const model::FramePair& pair, const std::string& name) {
        return geometric_jacobian(tree, pair, name, JacobianReference::spatial);
      },
      "spatial_");
  return list;
}

std::vector<RobotFunction> jacobian_derivatives_group(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "jacobian_derivatives", "jacobians", "Jd",
      [](const std::string& left, const std::string& right) {
        return "Time derivative of the geometric Jacobian " + left + "_J_" + right + ", angular rows first.";
      },
      [&](const model::FramePair& pair, const std::string& name) { return jacobian_derivative(tree, pair, name); });
  add_for_jacobians(
      list, tree, desired, "jacobian_derivatives", "jacobians", "Jd_qd",
      [](const std::string& left, const std::string& right) {
        return "Time derivative of " + left + "_J_" + right + " times the joint velocities: what is added to " + left +
               "_J_" + right + " qdd in the angular acceleration (rad/s^2) of " + right +
               " and the acceleration (m/s^2) of its origin, with respect to " + left + " and in its axes.";
      },
      [&](const model::FramePair& pair, const std::string& name) {
        return jacobian_derivative_times_velocity(tree, pair, name);
      });
  return list;
}

std::vector<RobotFunction> velocities_group(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "velocities", "velocities", "V",
      [](const std::string& left, const std::string& right) {
        return "Twist of " + right + " with respect to " + left + ", in coordinates of " + left +
               ": angular velocity (rad/s), then velocity (m/s) of the point of " + right +
               " that is at the origin of " + left + ".";
      },
      [&](const model::FramePair& pair, const std::string& name) { return frame_velocity(tree, pair, name); });
  return list;
}

std::vector<RobotFunction> accelerations_group(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  std::vector<RobotFunction> list;
  add_for_jacobians(
      list, tree, desired, "accelerations", "accelerations", "A",
      [](const std::string& left, const std::string& right) {
        return "Spatial acceleration of " + right + " with respect to " + left +
               ": the time derivative (rad/s^2, m/s^2) of its twist in coordinates of " + left +
               ", angular first (Featherstone 2008, ch. 2).";
      },
      [&](const model::FramePair& pair, const std::string& name) { return frame_acceleration(tree, pair, name); });
  return list;
}

}  // namespace

const std::vector<std::string>& groups() {
  static const std::vector<std::string> names = {"inverse_dynamics",
                                                 "bias_forces",
                                                 "forward_dynamics",
                                                 "joint_space_inertia",
                                                 "joint_space_inertia_factor",
                                                 "coriolis_matrix",
                                                 "centroidal",
                                                 "energy",
                                                 "transforms",
                                                 "jacobians",
                                                 "jacobian_references",
                                                 "jacobian_derivatives",
                                                 "velocities",
                                                 "accelerations"};
  return names;
}

const std::vector<std::string>& default_groups() {
  static const std::vector<std::string> names = {
      "inverse_dynamics",
      "bias_forces",
      "forward_dynamics",
      "joint_space_inertia",
      "joint_space_inertia_factor",
      "centroidal",
      "energy",
      "transforms",
      "jacobians"};
  return names;
}

std::vector<RobotFunction> functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const Formulation& formulation) {
  Formulations formulations(tree, formulation);
  return functions(tree, desired, group, formulations);
}

std::vector<RobotFunction> functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    Formulations& formulations) {
  if (group == "inverse_dynamics") return inverse_dynamics_group(tree, formulations);
  if (group == "bias_forces") return bias_forces_group(tree, formulations);
  if (group == "forward_dynamics") return forward_dynamics_group(tree, formulations);
  if (group == "joint_space_inertia") return joint_space_inertia_group(tree, formulations.inertia());
  if (group == "joint_space_inertia_factor") return joint_space_inertia_factor_group(tree, formulations.inertia());
  if (group == "coriolis_matrix") return coriolis_matrix_group(tree, formulations);
  if (group == "centroidal") return centroidal_group(tree, formulations.typical_of_model());
  if (group == "energy") return energy_group(tree, formulations);
  if (group == "transforms") return transforms_group(tree, desired);
  if (group == "jacobians") return jacobians_group(tree, desired);
  if (group == "jacobian_references") return jacobian_references_group(tree, desired);
  if (group == "jacobian_derivatives") return jacobian_derivatives_group(tree, desired);
  if (group == "velocities") return velocities_group(tree, desired);
  if (group == "accelerations") return accelerations_group(tree, desired);
  return {};
}

std::vector<std::optional<symbolic::Program>> alike_programs(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    Formulations& with_typical_limbs) {
  static const std::vector<std::string> kOfLimbs = {
      "inverse_dynamics",           "bias_forces",     "forward_dynamics", "joint_space_inertia",
      "joint_space_inertia_factor", "coriolis_matrix", "centroidal",       "energy"};
  if (std::find(kOfLimbs.begin(), kOfLimbs.end(), group) == kOfLimbs.end()) return {};
  std::vector<std::optional<symbolic::Program>> programs;
  for (RobotFunction& f : functions(tree, desired, group, with_typical_limbs)) {
    const bool is_other = std::any_of(f.program.constants.begin(), f.program.constants.end(), [](const Number& n) {
      return n.typical() != n.value();
    });
    programs.push_back(is_other ? std::optional(std::move(f.program)) : std::nullopt);
  }
  return programs;
}

}  // namespace robcogen::algorithm
