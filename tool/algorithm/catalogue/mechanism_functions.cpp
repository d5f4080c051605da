// Functions of joints that follow others, of loops, and of actuators between frames.
#include "algorithm/catalogue/groups.h"
#include "algorithm/catalogue/overloads.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/kinematics/actuators.h"
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/loop_functions.h"
#include "model/loops.h"
#include "model/named_frame.h"
#include "support/concat.h"

namespace robcogen::algorithm {

using model::KinematicTree;

namespace {

RobotFunction function(
    const std::string& group,
    const std::string& name,
    std::vector<std::string> summary,
    symbolic::Program program) {
  return {group, "", name, std::move(summary), {}, {}, std::move(program)};
}

// `bar (5 rows), rod (1)`.
std::string rows_of_loops(const KinematicTree& tree) {
  std::string text;
  for (const model::LoopJoint& loop : tree.loops)
    text += (text.empty() ? "" : ", ") + loop.name + " (" + std::to_string(rows_of(loop.type)) +
            (text.empty() ? rows_of(loop.type) == 1 ? " row)" : " rows)" : ")");
  return text;
}

std::string names_of_coupled(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (const model::Coupling& coupling : tree.couplings) names.push_back(tree.joints[at(coupling.joint)].name);
  return joined(names);
}

// `bar (3), rod (1)`: how many numbers describe the force of each loop. Loops that formulas close in a plane have no
// moment.
std::string parts_of_forces(const KinematicTree& tree) {
  std::vector<int> counts(tree.loops.size());
  for (const std::vector<model::Closure>* closures : {&tree.parallelograms, &tree.closures})
    for (const model::Closure& closure : *closures)
      for (const int loop : closure.loops) {
        const model::LoopType type = tree.loops[at(loop)].type;
        const bool is_whole = closure.method == model::Closure::Method::iterative && type != model::LoopType::point;
        counts[at(loop)] = type == model::LoopType::distance ? 1 : is_whole ? 6 : 3;
      }
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k)
    text += (text.empty() ? "" : ", ") + tree.loops[k].name + " (" + std::to_string(counts[k]) + ")";
  return text;
}

// The names of the joints that follow others, but not through a loop.
std::string names_of_declared_couplings(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (const model::Coupling& coupling : tree.couplings)
    if (coupling.is_linear() && coupling.loop < 0) names.push_back(tree.joints[at(coupling.joint)].name);
  return joined(names);
}

const char* const kAxesOfForces =
    "Forces are in the axes of the last link that carries both frames; if there are six numbers, the moment (N m) "
    "follows the force. The part that parallel joints share across a plane is left out. A distance has one number, "
    "positive if its rod is compressed.";

}  // namespace

void add_joint_positions(std::vector<RobotFunction>& list, const KinematicTree& tree) {
  if (tree.couplings.empty()) return;
  list.push_back(function(
      "transforms", "joint_positions",
      {"Positions of all joints (rad, m): first those of q, then those of the joints that follow them: " +
       names_of_coupled(tree) + "."},
      joint_positions(tree, "joint_positions")));
}

void add_actuator_lengths(std::vector<RobotFunction>& list, const KinematicTree& tree) {
  if (tree.actuators.empty()) return;
  list.push_back(function(
      "transforms", "actuator_lengths",
      {"Distances (m) between the two frames of each actuator: " + joined(model::names_of(tree.actuators)) + "."},
      actuator_lengths(tree, "actuator_lengths")));
}

void add_lever_arms(std::vector<RobotFunction>& list, const KinematicTree& tree) {
  if (tree.actuators.empty()) return;
  const auto add = [&](const std::string& name, std::vector<std::string> summary, auto build) {
    list.push_back(function("jacobians", name, std::move(summary), build(tree, name)));
  };
  add("actuator_velocities", {"Rates (m/s) of actuator lengths."}, actuator_velocities);
  add("actuator_jacobian",
      {"Derivatives of actuator lengths (rows) by coordinates (columns): lever arms (m), or ratios (m/m) for prismatic "
       "joints."},
      actuator_jacobian);
  add("actuator_torques",
      {"Joint forces (N m, N) due to actuator forces (N, positive if they push their frames apart): the transpose of "
       "actuator_jacobian times these."},
      actuator_torques);
  if (drives_separate_coordinates(tree))
    add("actuator_forces",
        {"Actuator forces (N) that give the joint forces tau of the coordinates that they move; not finite if a lever "
         "arm is zero."},
        actuator_forces);
}

void add_loop_errors(std::vector<RobotFunction>& list, const KinematicTree& tree) {
  if (tree.loops.empty()) return;
  const auto add = [&](const std::string& name, std::vector<std::string> summary, auto build) {
    list.push_back(function("transforms", name, std::move(summary), build(tree, name)));
  };
  add("joint_velocities", {"Velocities of all joints (rad/s, m/s), in the order of joint_positions."},
      joint_velocities);
  add("joint_accelerations", {"Accelerations of all joints (rad/s^2, m/s^2), in the order of joint_positions."},
      joint_accelerations);
  add("loop_error",
      {"Closure errors of loops, from the positions of all joints in the order of joint_positions: " +
           rows_of_loops(tree) + ".",
       "For each loop, the position of its second frame in its first one (m; for a slider x and y); for a hinge also x "
       "and y of the second frame's z axis in the first frame; for a slider and a weld also the sine of the angle "
       "between both frames, along its axis; for a distance its excess length (m)."},
      loop_error);
  if (tree.followers_in_q().empty()) return;
  add("close_loops",
      {"q in which the joints that follow close the loops: four steps of Newton's method from the given "
       "positions, which converge to rounding errors from within about 0.05 rad. The joints that follow have NaN if a "
       "loop remains open by more than 1e-5 m or rad."},
      close_loops);
}

void add_loop_jacobian(std::vector<RobotFunction>& list, const KinematicTree& tree) {
  if (tree.loops.empty()) return;
  list.push_back(function(
      "jacobians", "loop_jacobian", {"Derivative of loop_error by the positions of all joints."},
      loop_jacobian(tree, "loop_jacobian")));
}

void add_loop_forces(std::vector<RobotFunction>& list, const KinematicTree& tree, FormulationChoices& choices) {
  if (tree.loops.empty()) return;
  const Formulation& formulation = choices.newton_euler();
  add_overloads(
      list, tree, "inverse_dynamics", "loop_forces",
      {"Forces (N) of the second frame of each loop on the first one during a motion, if joints that follow have no "
       "motors: " +
           parts_of_forces(tree) + ".",
       kAxesOfForces},
      [&](const std::string& kernel, Loads loads) { return loop_forces(tree, kernel, loads, formulation); });
}

void add_loop_constrained_dynamics(
    std::vector<RobotFunction>& list,
    const KinematicTree& tree,
    FormulationChoices& choices) {
  if (tree.loops.empty()) return;
  if (model::with_free_joints(tree).inertia_defects.is_singular()) {
    for (RobotFunction& f : list)
      f.summary.emplace_back(
          "loop_constrained_forward_dynamics is left out: with cut loops, a joint moves no inertia.");
    return;
  }
  const Formulation& formulation = choices.forward_dynamics().formulation;
  const std::string name = "loop_constrained_forward_dynamics";
  const std::string couplings = names_of_declared_couplings(tree);
  std::vector<std::string> summary = {
      "Accelerations of all joints with cut loops, and the forces that close the loops, for simulators that integrate "
      "all joints; positions, velocities, joint forces and accelerations are in the order of joint_positions" +
          std::string(
              tree.spherical_joints().empty() ? "." : ", and scalar parts of quaternions follow the positions."),
      "`stabilization`: gains of the loop errors (1/s^2) and of their rates (1/s), such as a^2 and 2 a, with which the "
      "errors decay as in a damped oscillator (Baumgarte 1972); zeros for none. `compliance` is added to the diagonal "
      "of the inverse inertia at the loops: zero for rigid loops; a small number, such as 1e-8, lets the motion "
      "pass through positions in which loops are stretched.",
      "`loop_forces`: forces (N) of the second frame of each loop on the first one: " + parts_of_forces(tree) + ". " +
          kAxesOfForces};
  if (!couplings.empty())
    summary.push_back("`coupling_forces`: forces (N m, N) of couplings on the joints that follow: " + couplings + ".");
  if (tree.floating_base)
    summary.emplace_back("`base_velocity` and `base_acceleration` (spatial) are in base coordinates, angular first.");
  add_overloads(list, tree, "forward_dynamics", name, summary, [&](const std::string& kernel, Loads loads) {
    return loop_constrained_forward_dynamics(tree, kernel, loads, formulation);
  });
  add_method(list, name, description(tree, formulation.frames));
}

}  // namespace robcogen::algorithm
