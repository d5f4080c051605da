// Derivatives of the dynamics.
#include "algorithm/catalogue/arrays.h"
#include "algorithm/catalogue/sizes.h"
#include "algorithm/dynamics/dynamics.h"

namespace robcogen::algorithm::catalogue {
namespace {

// The meaning of the rows, and of the columns of the base.
constexpr const char* kRowsOfAcceleration =
    "{floating? (6 + n) rows: those of the base acceleration first. All quantities of the base are in base "
    "coordinates, angular first.}";
constexpr const char* kRowsOfWrench =
    "{floating? (6 + n) rows: those of the base wrench first. All quantities of the base are in base coordinates, "
    "angular first.}";
#define COLUMNS_OF_BASE(by)                                                                                         \
  "{floating? Columns of the base: by " by                                                                          \
  "a rotation of the base about its own axes (d_base_rotation); gravity is fixed in the world and changes in base " \
  "coordinates.}"
constexpr const char* kColumnsOfBase = COLUMNS_OF_BASE("the base's velocity (d_base_velocity), and ");

const Array d_q = matrix("d_q", velocities, coordinates);
const Array d_qd = matrix("d_qd", velocities, coordinates);
const Array d_qdd = matrix("d_qdd", velocities, coordinates, is_floating);
const Array inertia{"d_qdd", Role::inertia_matrix, velocities, coordinates, is_fixed};
const Array d_tau = matrix("d_tau", velocities, coordinates);
const Array d_base_rotation = matrix("d_base_rotation", velocities, rows<3>, is_floating);
const Array d_base_velocity = matrix("d_base_velocity", velocities, rows<6>, is_floating);
const Array d_base_acceleration = matrix("d_base_acceleration", velocities, rows<6>, is_floating);

}  // namespace

Declarations derivative_declarations() {
  return {
      {"inverse_dynamics_derivatives",
       {{.name = "inverse_dynamics_derivatives",
         .exists = is_fixed,
         .summary =
             {"Joint forces tau (N m, N) for joint accelerations qdd, and their partial derivatives: a column for each "
              "joint's position (d_q), velocity (d_qd) and acceleration (d_qdd, the joint-space inertia matrix)."},
         .signature = {{q, qd, qdd}, {tau, d_q, d_qd, inertia}, Overloads::gravity_and_external},
         .program = {by<inverse_dynamics_derivatives>, Search::inverse_dynamics_derivatives},
         .remarks = {kConstantWrenches}},
        {.name = "inverse_dynamics_derivatives",
         .exists = has_free_base,
         .summary =
             {"Joint forces tau (N m, N) for joint accelerations qdd, the spatial acceleration of the unactuated base, "
              "and their partial derivatives: a column for each joint's position (d_q), velocity (d_qd) and "
              "acceleration (d_qdd).",
              kRowsOfAcceleration, kColumnsOfBase},
         .signature =
             {{q, qd, qdd, base_velocity},
              {tau, base_acceleration, d_q, d_qd, d_qdd, d_base_rotation, d_base_velocity},
              Overloads::gravity_and_external},
         .program = {by<unactuated_base_inverse_dynamics_derivatives>, Search::inverse_dynamics_derivatives},
         .remarks = {kConstantWrenches},
         .in_columns =
             ColumnForm{
                 [](const Subject& s) { return operations_of_base_solutions(s.tree); }, are_better_in_columns_for_base,
                 by<unactuated_base_inverse_dynamics_derivatives_in_columns>}},
        {.name = "inverse_dynamics_fully_actuated_derivatives",
         .exists = is_floating,
         .summary =
             {"Joint forces tau (N m, N) for joint accelerations qdd, the wrench on the base, and their partial "
              "derivatives: a column for each joint's position (d_q), velocity (d_qd) and acceleration (d_qdd).",
              kRowsOfWrench,
              COLUMNS_OF_BASE(
                  "the base's velocity (d_base_velocity), its spatial acceleration (d_base_acceleration), and ")},
         .signature =
             {motion,
              {tau, base_wrench, d_q, d_qd, d_qdd, d_base_rotation, d_base_velocity, d_base_acceleration},
              Overloads::gravity_and_external},
         .program = {by<inverse_dynamics_derivatives>, Search::inverse_dynamics_derivatives},
         .remarks = {kConstantWrenches}},
        {.name = "gravity_forces_derivative",
         .summary =
             {"Partial derivatives of the generalised forces that hold the robot at rest against gravity: a column for "
              "each joint's position{floating?  (d_q).}{fixed? {spherical? .}{no spherical? ; symmetric.}}",
              kRowsOfWrench, COLUMNS_OF_BASE("")},
         .signature = {{q}, {d_q, d_base_rotation}, Overloads::gravity},
         .program = {by<gravity_forces_derivative>, Search::cheaper}}}},
      {"inverse_dynamics_gradient",
       {{.name = "inverse_dynamics_gradient",
         .summary =
             {"{floating? Joint forces tau (N m, N) and the wrench on the base for joint and base accelerations, and "
              "the gradient of `weights` times these forces, weights of the base wrench first.}"
              "{fixed? Joint forces tau (N m, N) for joint accelerations qdd, and the gradient of `weights` times "
              "tau.}",
              "The gradient is the transpose of the derivatives times `weights`, computed by reverse mode at a small "
              "multiple of the cost of inverse dynamics."},
         .signature =
             {{q, qd, qdd, base_velocity, base_acceleration, value("weights", velocities)},
              {tau, base_wrench, value("d_q", coordinates), value("d_qd", coordinates), value("d_qdd", coordinates),
               value("d_base_velocity", rows<6>, is_floating), value("d_base_acceleration", rows<6>, is_floating)},
              Overloads::gravity_and_external},
         .program = {by<inverse_dynamics_gradient>, Search::newton_euler},
         .remarks = {kConstantWrenches}}}},
      {"inverse_dynamics_second_derivatives",
       {{.name = "inverse_dynamics_second_derivatives",
         .summary =
             {"The gradient of `weights` times the joint forces tau (N m, N), and its derivatives: the terms of "
              "inverse dynamics in second-order methods of optimal control.",
              "Rows belong to the first input in a name, columns to the second; {no spherical? d_q_q and d_qd_qd are}"
              "{spherical? d_qd_qd is} symmetric. Accelerations enter linearly: all other blocks are zero.",
              "{floating? `weights` are in the order of the base wrench, then of the joints. All quantities of the "
              "base are in base coordinates, angular first.}"},
         .signature =
             {{q, qd, qdd, base_velocity, base_acceleration, value("weights", velocities)},
              {tau, base_wrench, value("d_q", coordinates), value("d_qd", coordinates), value("d_qdd", coordinates),
               value("d_base_velocity", rows<6>, is_floating), value("d_base_acceleration", rows<6>, is_floating),
               matrix("d_q_q", coordinates, coordinates), matrix("d_qd_q", coordinates, coordinates),
               matrix("d_qdd_q", coordinates, coordinates), matrix("d_qd_qd", coordinates, coordinates),
               matrix("d_base_velocity_q", rows<6>, coordinates, is_floating),
               matrix("d_base_acceleration_q", rows<6>, coordinates, is_floating),
               matrix("d_base_velocity_qd", rows<6>, coordinates, is_floating),
               matrix("d_base_velocity_base_velocity", rows<6>, rows<6>, is_floating)},
              Overloads::gravity_and_external},
         .program = {by<inverse_dynamics_second_derivatives>, Search::newton_euler},
         .remarks = {kConstantWrenches}}}},
      {"forward_dynamics_derivatives",
       {{.name = "forward_dynamics_derivatives",
         .summary =
             {"Joint accelerations qdd (rad/s^2, m/s^2) from joint forces tau, and their partial derivatives: a column "
              "for each joint's position (d_q), velocity (d_qd) and force (d_tau: of the inverse of the joint-space "
              "inertia matrix).",
              kRowsOfAcceleration, kColumnsOfBase},
         .signature =
             {{q, qd, tau, base_velocity},
              {qdd, base_acceleration, d_q, d_qd, d_tau, d_base_rotation, d_base_velocity},
              Overloads::gravity_and_external},
         .program = {by<forward_dynamics_derivatives>, Search::inverse_dynamics_derivatives},
         .remarks = {kConstantWrenches},
         .in_columns = ColumnForm{
             [](const Subject& s) { return operations_of_solutions(s.tree); }, are_better_in_columns,
             by<forward_dynamics_derivatives_in_columns>}}}}};
}

}  // namespace robcogen::algorithm::catalogue
