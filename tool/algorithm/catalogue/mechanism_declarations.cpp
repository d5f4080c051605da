// Functions of joints that follow others, of loops, of actuators between frames, and of quaternions. They are added to
// the groups of other functions.
#include <algorithm>

#include "algorithm/catalogue/arrays.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/kinematics/actuators.h"
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/loop_functions.h"

namespace robcogen::algorithm::catalogue {
namespace {

#define AXES_OF_FORCES                                                                                             \
  "Forces are in the axes of the last link that carries both frames; if there are six numbers, the moment (N m) "  \
  "follows the force. The part that parallel joints share across a plane is left out. A distance has one number, " \
  "positive if its rod is compressed."

bool has_couplings(const Subject& s) {
  return !s.tree.couplings.empty();
}

bool has_actuators(const Subject& s) {
  return !s.tree.actuators.empty();
}

bool has_separate_actuators(const Subject& s) {
  return has_actuators(s) && drives_separate_coordinates(s.tree);
}

bool has_followers(const Subject& s) {
  return !s.tree.followers_in_q().empty();
}

bool may_cut_loops(const Subject& s) {
  return has_loops(s) && !lacks_inertia_with_cut_loops(s);
}

// Positions of robots with spherical joints cannot simply be added. If q has followers, their loops would have to be
// closed as well.
bool has_quaternions_alone(const Subject& s) {
  return has_spherical_joints(s) && !has_followers(s);
}

int numbers_of_loop_forces(const Subject& s) {
  int numbers = 0;
  for (const int count : force_counts(s.tree)) numbers += count;
  return numbers;
}

int declared_couplings(const Subject& s) {
  return static_cast<int>(std::count_if(s.tree.couplings.begin(), s.tree.couplings.end(), is_declared));
}

int joints_and_scalars(const Subject& s) {
  return joints(s) + static_cast<int>(s.tree.spherical_joints().size());
}

}  // namespace

Declarations mechanism_declarations() {
  return {
      {"transforms",
       {{.name = "joint_positions",
         .exists = has_couplings,
         .summary = {"Positions of all joints (rad, m): first those of q, then those of the joints that follow them: "
                     "{coupled joints}."},
         .signature = {{q}, {value("positions", joints)}},
         .program = {by<joint_positions>}},
        {.name = "actuator_lengths",
         .exists = has_actuators,
         .summary = {"Distances (m) between the two frames of each actuator: {actuators}."},
         .signature = {{q}, {value("lengths", actuators)}},
         .program = {by<actuator_lengths>}},
        {.name = "joint_velocities",
         .exists = has_loops,
         .summary = {"Velocities of all joints (rad/s, m/s), in the order of joint_positions."},
         .signature = {{q, qd}, {value("velocities", joints)}},
         .program = {by<joint_velocities>}},
        {.name = "joint_accelerations",
         .exists = has_loops,
         .summary = {"Accelerations of all joints (rad/s^2, m/s^2), in the order of joint_positions."},
         .signature = {{q, qd, qdd}, {value("accelerations", joints)}},
         .program = {by<joint_accelerations>}},
        {.name = "loop_error",
         .exists = has_loops,
         .summary =
             {"Closure errors of loops, from the positions of all joints in the order of joint_positions: {rows of "
              "loops}.",
              "For each loop, the position of its second frame in its first one (m; for a slider x and y); for a hinge "
              "also x and y of the second frame's z axis in the first frame; for a slider and a weld also the sine of "
              "the angle between both frames, along its axis; for a distance its excess length (m)."},
         .signature = {{value("positions", joints_and_scalars)}, {value("error", loop_rows)}},
         .program = {by<loop_error>}},
        {.name = "close_loops",
         .exists = has_followers,
         .summary = {"q in which the joints that follow close the loops: four steps of Newton's method from the given "
                     "positions, which converge to rounding errors from within about 0.05 rad. The joints that follow "
                     "have NaN if a loop remains open by more than 1e-5 m or rad."},
         .signature = {{q}, {value("q", positions)}},
         .program = {by<close_loops>}},
        {.name = "integrate_positions",
         .exists = has_quaternions_alone,
         .summary =
             {"Joint positions after one second at constant velocities qd, or after another time if qd is multiplied "
              "by it.",
              "Spherical joints rotate about a fixed axis, exactly; the resulting quaternions have unit length."},
         .signature = {{q, qd}, {value("positions", positions)}},
         .program = {by<integrate_positions>}},
        {.name = "position_difference",
         .exists = has_quaternions_alone,
         .summary =
             {"The constant velocities that lead from one position to another in one second: the inverse of "
              "integrate_positions.",
              "A spherical joint takes the shorter path, of at most half a turn."},
         .signature = {{{"q_from", Role::joint_position, positions}, {"q_to", Role::joint_position, positions}}, {qd}},
         .program = {by<position_difference>}}}},
      {"jacobians",
       {{.name = "actuator_velocities",
         .exists = has_actuators,
         .summary = {"Rates (m/s) of actuator lengths."},
         .signature = {{q, qd}, {value("velocities", actuators)}},
         .program = {by<actuator_velocities>}},
        {.name = "actuator_jacobian",
         .exists = has_actuators,
         .summary = {"Derivatives of actuator lengths (rows) by coordinates (columns): lever arms (m), or ratios (m/m) "
                     "for prismatic joints."},
         .signature = {{q}, {matrix("J", actuators, coordinates)}},
         .program = {by<actuator_jacobian>}},
        {.name = "actuator_torques",
         .exists = has_actuators,
         .summary = {"Joint forces (N m, N) due to actuator forces (N, positive if they push their frames apart): the "
                     "transpose of actuator_jacobian times these."},
         .signature = {{q, value("forces", actuators)}, {tau}},
         .program = {by<actuator_torques>}},
        {.name = "actuator_forces",
         .exists = has_separate_actuators,
         .summary = {"Actuator forces (N) that give the joint forces tau of the coordinates that they move; not finite "
                     "if a lever arm is zero."},
         .signature = {{q, tau}, {value("forces", actuators)}},
         .program = {by<actuator_forces>}},
        {.name = "loop_jacobian",
         .exists = has_loops,
         .summary = {"Derivative of loop_error by the positions of all joints."},
         .signature = {{value("positions", joints_and_scalars)}, {matrix("K", loop_rows, joints)}},
         .program = {by<loop_jacobian>}}}},
      {"inverse_dynamics",
       {{.name = "loop_forces",
         .exists = has_loops,
         .summary =
             {"Forces (N) of the second frame of each loop on the first one during a motion, if joints that follow "
              "have no motors: {forces of loops}.",
              AXES_OF_FORCES},
         .signature =
             {{q, qd, qdd, base_velocity, base_acceleration},
              {value("forces", numbers_of_loop_forces)},
              Overloads::gravity_and_external},
         .program = {by<loop_forces>, Search::newton_euler},
         .method = Method::none}}},
      {"forward_dynamics",
       {{.name = "loop_constrained_forward_dynamics",
         .exists = may_cut_loops,
         .summary =
             {"Accelerations of all joints with cut loops, and the forces that close the loops, for simulators that "
              "integrate all joints; positions, velocities, joint forces and accelerations are in the order of "
              "joint_positions{spherical? , and scalar parts of quaternions follow the positions}.",
              "`stabilization`: gains of the loop errors (1/s^2) and of their rates (1/s), such as a^2 and 2 a, with "
              "which the errors decay as in a damped oscillator (Baumgarte 1972); zeros for none. `compliance` is "
              "added to the diagonal of the inverse inertia at the loops: zero for rigid loops; a small number, such "
              "as 1e-8, lets the motion pass through positions in which loops are stretched.",
              "`loop_forces`: forces (N) of the second frame of each loop on the first one: {forces of "
              "loops}. " AXES_OF_FORCES,
              "{couplings? `coupling_forces`: forces (N m, N) of couplings on the joints that follow: {declared "
              "couplings}.}",
              "{floating? `base_velocity` and `base_acceleration` (spatial) are in base coordinates, angular first.}"},
         .signature =
             {{value("positions", joints_and_scalars),
               value("velocities", joints),
               value("joint_forces", joints),
               base_velocity,
               value("stabilization", rows<2>),
               {"compliance", Role::contact_compliance, rows<1>}},
              {value("accelerations", joints), base_acceleration, value("loop_forces", numbers_of_loop_forces),
               value("coupling_forces", declared_couplings, has_declared_couplings)},
              Overloads::gravity_and_external},
         .program = {by<loop_constrained_forward_dynamics>, Search::forward_dynamics}}}}};
}

}  // namespace robcogen::algorithm::catalogue
