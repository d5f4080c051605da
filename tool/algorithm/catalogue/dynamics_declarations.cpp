// Dynamics of the whole robot.
#include "algorithm/catalogue/arrays.h"
#include "algorithm/catalogue/sizes.h"
#include "algorithm/dynamics/dynamics.h"

namespace robcogen::algorithm::catalogue {
namespace {

symbolic::Program with_choice(const Tracing& t) {
  return forward_dynamics(t.tree, t.name, t.loads, t.choice);
}

symbolic::Program bias_of_robot(const Tracing& t) {
  return bias_forces(t.tree, t.name, t.loads, t.choice.formulation);
}

constexpr const char* kBaseOfForces =
    "{floating? `base_velocity` and `base_wrench` are in base coordinates, angular first.}";
constexpr const char* kSizeOfInertia =
    "{floating? (6 + n) x (6 + n): base rows first, in base coordinates, angular first.}"
    "{fixed? n x n, joints in the order of the model.}";
constexpr const char* kRowsOfFactor =
    "{floating? (6 + n) rows: base first, in base coordinates, angular first.}"
    "{fixed? n rows, joints in the order of the model.}";
constexpr const char* kColumnsOfVelocity =
    "{floating? (6 + n) columns: for the velocity (base twist in base coordinates, angular first; qd).}"
    "{fixed? n columns, joints in the order of the model.}";

const Array L{"L", Role::inertia_factor, velocities, velocities};
const Array inverse_diagonal{"inverse_diagonal", Role::inverse_diagonal, velocities};

}  // namespace

Declarations dynamics_declarations() {
  return {
      {"inverse_dynamics",
       {{.name = "inverse_dynamics",
         .exists = is_fixed,
         .summary =
             {"Joint forces tau (N m, N) for joint accelerations qdd: recursive Newton-Euler (Featherstone 2008, ch. "
              "5)."},
         .signature = {{q, qd, qdd}, {tau}, Overloads::gravity_and_external},
         .program = {by<newton_euler>, Search::newton_euler}},
        {.name = "inverse_dynamics",
         .exists = has_free_base,
         .summary =
             {"Joint forces tau (N m, N) for joint accelerations qdd, and the spatial acceleration of the unactuated "
              "base (Featherstone 2008, sec. 9.4).",
              "`base_velocity` and `base_acceleration` are in base coordinates, angular first."},
         .signature = {{q, qd, qdd, base_velocity}, {tau, base_acceleration}, Overloads::gravity_and_external},
         .program = {by<unactuated_base_inverse_dynamics>, Search::unactuated_base}},
        {.name = "inverse_dynamics_fully_actuated",
         .exists = is_floating,
         .summary =
             {"Joint forces tau (N m, N) and the wrench on the base for joint and base accelerations: recursive "
              "Newton-Euler (Featherstone 2008, ch. 5).",
              "`base_velocity`, `base_acceleration` (spatial, gravity not included) and `base_wrench` are in base "
              "coordinates, angular first."},
         .signature =
             {{q, qd, qdd, base_velocity, base_acceleration}, {tau, base_wrench}, Overloads::gravity_and_external},
         .program = {by<newton_euler>, Search::newton_euler}}}},
      {"bias_forces",
       {{.name = "bias_forces",
         .summary =
             {"Generalised forces at zero acceleration: Coriolis, centrifugal, gravity, {has passive forces? "
              "passive forces of drives, }minus external forces.",
              kBaseOfForces},
         .signature = {{q, qd, base_velocity}, {tau, base_wrench}, Overloads::gravity_and_external},
         .program = {bias_of_robot, Search::newton_euler}},
        {.name = "gravity_forces",
         .summary = {"Generalised forces that hold the robot at rest against gravity.", kBaseOfForces},
         .signature = {{q}, {tau, base_wrench}, Overloads::gravity},
         .program = {by<gravity_forces>, Search::cheaper}},
        {.name = "coriolis_forces",
         .summary = {"Generalised forces due to velocities: bias forces without gravity.", kBaseOfForces},
         .signature = {{q, qd, base_velocity}, {tau, base_wrench}},
         .program = {by<coriolis_forces>, Search::newton_euler}}}},
      {"passive_forces",
       {{.name = "passive_forces",
         .summary = {"Joint forces that overcome damping, friction and springs of the drives: tau = b qd + f s(qd) + k "
                     "(q - q0), with s(qd) = qd / sqrt(qd^2 + v^2), which is the sign of qd if v is zero. "
                     "{tendons? A tendon of length l, a sum of c q, adds c (k (l - rest) + d dl/dt) for each joint. }"
                     "{passive? Inverse dynamics and bias forces include them.}"
                     "{not passive? Inverse dynamics and bias forces do not include them{tendons? , except those of "
                     "tendons}.}"},
         .signature = {{q, qd}, {tau}},
         .program = {by<passive_forces>}},
        {.name = "motor_torques",
         .exists = [](const Subject& s) { return s.tree.has_rotors(); },
         .summary = {"Torques (N m) at the motor shafts for joint forces tau: tau divided by the ratio of the rotor, "
                     "without gear losses; tau itself for a joint without rotor. With tau of inverse dynamics, they "
                     "are the total torques of the motors: for their rotors, for passive forces, and for the robot."},
         .signature = {{tau}, {{"torque", Role::joint_force, coordinates}}},
         .program = {by<motor_torques>}}}},
      {"forward_dynamics",
       {{.name = "forward_dynamics",
         .summary =
             {"Joint accelerations qdd (rad/s^2, m/s^2) from joint forces tau{source}.",
              "{floating? `base_velocity` and `base_acceleration` (spatial) are in base coordinates, angular first.}"},
         .signature = {{q, qd, tau, base_velocity}, {qdd, base_acceleration}, Overloads::gravity_and_external},
         .program = {with_choice, Search::forward_dynamics},
         .remarks = {"{free joints? loop_constrained_forward_dynamics is left out: with cut loops, a joint moves no "
                     "inertia.}"},
         .method = Method::algorithm_and_frames}}},
      {"joint_space_inertia",
       {{.name = "joint_space_inertia",
         .summary =
             {"Joint-space inertia matrix H, symmetric, structural zeros literal: composite rigid bodies (Featherstone "
              "2008, ch. 6).",
              kSizeOfInertia},
         .signature = {{q}, {{"H", Role::inertia_matrix, velocities, velocities}}},
         .program = {by<joint_space_inertia>, Search::inertia}}}},
      {"joint_space_inertia_factor",
       {{.name = "joint_space_inertia_factor",
         .summary =
             {"Factor L of the joint-space inertia matrix H = L^T L: zero except on the diagonal and at the ancestors "
              "of each coordinate; and the reciprocals of its diagonal (Featherstone 2008, sec. 6.5).",
              kRowsOfFactor},
         .signature = {{q}, {L, inverse_diagonal}},
         .program = {[](const Tracing& t) { return t.choices.inertia_factor(); }, Search::inertia}},
        {.scope = "inertia_factor",
         .name = "solve",
         .summary = {"y = H^-1 x, by substitution along the ancestors of each coordinate.", kRowsOfFactor},
         .signature = {{L, inverse_diagonal, value("x", velocities)}, {value("y", velocities)}},
         .program = {by<inertia_factor_solve>, Search::inertia},
         .method = Method::none},
        {.scope = "inertia_factor",
         .name = "inverse",
         .summary = {"H^-1, symmetric; structural zeros are literal.", kRowsOfFactor},
         .signature = {{L, inverse_diagonal}, {{"inverse", Role::inertia_matrix, velocities, velocities}}},
         .program = {by<inertia_factor_inverse>, Search::inertia},
         .method = Method::none,
         .in_columns =
             ColumnForm{
                 [](const Subject& s) { return operations_of_inverse(s.tree); }, are_better_in_columns,
                 by<inertia_factor_inverse_in_columns>}},
        {.scope = "inertia_factor",
         .name = "inverse_L",
         .summary = {"L^-1, with the zeros of L.", kRowsOfFactor},
         .signature = {{L, inverse_diagonal}, {matrix("inverse", velocities, velocities)}},
         .program = {by<inertia_factor_inverse_L>, Search::inertia},
         .method = Method::none,
         .in_columns =
             ColumnForm{
                 [](const Subject& s) { return operations_of_inverse(s.tree) / 2; }, are_better_in_columns,
                 by<inertia_factor_inverse_L_in_columns>}}}},
      {"coriolis_matrix",
       {{.name = "coriolis_matrix",
         .summary =
             {"Coriolis matrix C: C times the velocity gives the generalised forces due to velocities, and dH/dt - 2 C "
              "is skew symmetric (Niemeyer and Slotine 1991; Echeandia and Wensing 2021).",
              "{floating? (6 + n) x (6 + n), as the joint-space inertia matrix H: for the velocity (base twist, qd), "
              "in base coordinates, angular first.}{fixed? n x n, joints in the order of the model.}"},
         .signature = {{q, qd, base_velocity}, {matrix("C", velocities, velocities)}},
         .program = {by<coriolis_matrix>, Search::cheaper},
         .is_of_model = true}}},
      {"control_terms",
       {{.name = "generalized_momentum",
         .summary =
             {"Generalised momentum p = H v, for the joint-space inertia matrix H and the velocity v ({floating? base "
              "twist, }qd), and its rate without generalised forces: dp/dt = {floating? (base wrench, }tau{floating? "
              ")} + rate (De Luca and Mattone 2003).",
              "The rate is C' v minus gravity forces{has passive forces? , minus passive forces of drives}, with a "
              "Coriolis matrix C for which dH/dt - 2 C is skew symmetric.",
              "{floating? (6 + n) rows: base first, in base coordinates, angular first.}"},
         .signature = {{q, qd, base_velocity}, {value("p", velocities), value("rate", velocities)}, Overloads::gravity},
         .program = {by<generalized_momentum>, Search::newton_euler}},
        {.name = "path_dynamics",
         .exists = is_fixed,
         .summary =
             {"Joint forces along a path q(s): tau = a dds/dt^2 + b (ds/dt)^2 + c, where qd is dq/ds and qdd is "
              "d^2q/ds^2; without passive forces of drives (Bobrow, Dubowsky and Gibson 1985; Pham 2014).",
              "a = H qd, b = H qdd + C qd, and c are the gravity forces."},
         .signature =
             {{q, qd, qdd},
              {{"a", Role::joint_force, coordinates},
               {"b", Role::joint_force, coordinates},
               {"c", Role::joint_force, coordinates}},
              Overloads::gravity},
         .program = {by<path_dynamics>, Search::newton_euler}}}},
      {"centroidal",
       {{.name = "center_of_mass",
         .summary = {"Centre of mass of {what moves} (m), in base coordinates."},
         .signature = {{q}, {{"com", Role::position, rows<3>}}},
         .program = {by<center_of_mass>},
         .joins_frames = true},
        {.name = "center_of_mass_jacobian",
         .summary = {"Velocity (m/s) of the centre of mass of {what moves}, in base axes: 3 rows.", kColumnsOfVelocity},
         .signature = {{q}, {matrix("J", rows<3>, velocities)}},
         .program = {by<center_of_mass_jacobian>},
         .joins_frames = true},
        {.name = "centroidal_momentum_matrix",
         .summary =
             {"Spatial momentum of {what moves} about the centre of mass, in base axes: 3 rows of angular momentum (N "
              "m s), 3 of linear momentum (N s) (Orin, Goswami, Lee 2013).",
              kColumnsOfVelocity},
         .signature = {{q}, {matrix("A", rows<6>, velocities)}},
         .program = {by<centroidal_momentum_matrix>},
         .joins_frames = true},
        {.name = "total_mass",
         .exists = [](const Subject& s) { return !s.tree.parameters.empty(); },  // otherwise it is a constant
         .summary = {"Mass of {what moves} (kg)."},
         .signature = {{}, {{"mass", Role::mass, rows<1>}}},
         .program = {by<total_mass>}}}},
      {"energy",
       {{.name = "kinetic_energy",
         .summary =
             {"Kinetic energy (J), summed over the links.",
              "{floating? `base_velocity` is in base coordinates, angular first.}"},
         .signature = {{q, qd, base_velocity}, {{"T", Role::energy, rows<1>}}},
         .program = {by<kinetic_energy>, Search::cheaper}},
        {.name = "potential_energy",
         .summary = {"Potential energy (J) of {what moves}, zero where their centre of mass is at the base origin."},
         .signature = {{q}, {{"V", Role::energy, rows<1>}}, Overloads::gravity},
         .program = {by<potential_energy>}}}},
      {"centroidal_bias",
       {{.name = "centroidal_momentum_bias",
         .summary =
             {"Bias of the centroidal momentum: the rate of angular (N m) and linear (N) momentum minus the centroidal "
              "momentum matrix times {accelerations}, in an inertial frame and in base axes, angular first (Wensing "
              "and "
              "Orin 2016).",
              "The rate of the momentum equals the external moment about the centre of mass, and the external force."},
         .signature = {{q, qd, base_velocity}, {value("bias", rows<6>)}},
         .program = {by<centroidal_momentum_bias>},
         .joins_frames = true}}}};
}

}  // namespace robcogen::algorithm::catalogue
