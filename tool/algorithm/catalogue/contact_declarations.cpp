// Functions of contacts, of all desired contact frames.
#include "algorithm/catalogue/arrays.h"
#include "algorithm/catalogue/sizes.h"
#include "algorithm/dynamics/contacts.h"

namespace robcogen::algorithm::catalogue {
namespace {

constexpr const char* kContactRows =
    "Contacts: {contacts}. Rows are in this order: velocities (m/s) or forces (N) of a point; for a surface, angular "
    "velocities or moments first. They are in base axes, about the origin of the contact frame.";
constexpr const char* kBase = "{floating? All quantities of the base are in base coordinates, angular first.}";
constexpr const char* kSwitches =
    "`active`: 1 for an active contact, 0 for an open one. `compliance` (per row) is added to the diagonal of W: zero "
    "for rigid contacts, whose rows must be independent; a small number lets redundant contacts share the load.";
const Array active{"active", Role::contact_activity, contact_count};
const Array compliance{"compliance", Role::contact_compliance, contact_rows};
const Array contact_acceleration = value("contact_acceleration", contact_rows);
const Array contact_wrenches = value("contact_wrenches", contact_rows);
const Array contact_impulses = value("contact_impulses", contact_rows);
const Array restitution = value("restitution", contact_count);
const Array qd_after{"qd_after", Role::joint_velocity, coordinates};
const Array base_velocity_after{"base_velocity_after", Role::base_velocity, rows<6>, nullptr, is_floating};

// A derivative of accelerations or velocities, and of wrenches or impulses.
constexpr Array d(const char* name, Size columns, Condition exists = nullptr) {
  return matrix(name, velocities_and_contact_rows, columns, exists);
}

symbolic::Program bias_of_contacts(const Tracing& t) {
  return contact_bias(t.tree, t.contacts, t.name);
}

long operations(const Subject& s) {
  return operations_of_contact_solutions(s.tree, s.contacts);
}

}  // namespace

Declarations contact_declarations() {
  return {
      {"contacts",
       {{.name = "contact_jacobian",
         .of = Of::contacts,
         .summary =
             {"Jacobian J of the contacts: velocities of the contact frames in an inertial frame, a column for each "
              "coordinate of the joint-space inertia matrix.",
              kContactRows, kBase},
         .signature = {{q}, {matrix("J", contact_rows, velocities)}},
         .program = {by<contact_jacobian>}},
        {.name = "contact_velocity",
         .of = Of::contacts,
         .summary = {"Velocities of the contact frames: J times the velocities of the robot.", kContactRows, kBase},
         .signature = {{q, qd, base_velocity}, {value("velocity", contact_rows)}},
         .program = {by<contact_velocity>}},
        {.name = "contact_bias",
         .of = Of::contacts,
         .summary =
             {"Accelerations of the contact frames in an inertial frame minus J times {fixed? the joint accelerations "
              "}{accelerations}.",
              kContactRows, kBase},
         .signature = {{q, qd, base_velocity}, {value("bias", contact_rows)}},
         .program = {bias_of_contacts}},
        {.name = "inverse_contact_inertia",
         .of = Of::contacts,
         .summary =
             {"W = J H^-1 J^T: accelerations of the contact frames due to unit wrenches on them; structural zeros are "
              "literal (Featherstone 2008, sec. 8.4).",
              kContactRows, kBase},
         .signature = {{q}, {matrix("W", contact_rows, contact_rows)}},
         .program = {by<inverse_contact_inertia>, Search::inertia}},
        {.name = "constrained_forward_dynamics",
         .of = Of::contacts,
         .summary =
             {"Accelerations from joint forces tau, and the wrenches of the contacts on the robot: active contacts "
              "have the acceleration `contact_acceleration`, zero, or -2 a velocity - a^2 error to remove a position "
              "error (Baumgarte 1972).",
              kSwitches, kContactRows, kBase},
         .signature =
             {{q, qd, tau, base_velocity, contact_acceleration, active, compliance},
              {qdd, base_acceleration, contact_wrenches},
              Overloads::gravity_and_external},
         .program = {by<constrained_forward_dynamics>, Search::cheapest}},
        {.name = "impact",
         .of = Of::contacts,
         .summary =
             {"Velocities after an impact at active contacts, and impulses (N s) of the contacts on the robot: a "
              "contact leaves with -restitution times its velocity; `restitution` has one element per contact.",
              kSwitches, kContactRows, kBase},
         .signature =
             {{q, qd, base_velocity, restitution, active, compliance},
              {qd_after, base_velocity_after, contact_impulses}},
         .program = {by<impact>, Search::inertia}},
        {.name = "inverse_dynamics_with_contacts",
         .of = Of::contacts,
         .summary =
             {"Joint forces tau{floating?  and the wrench that the base still needs} for accelerations and given "
              "wrenches of the contacts on the robot.",
              kContactRows, kBase},
         .signature =
             {{q, qd, qdd, base_velocity, base_acceleration, contact_wrenches},
              {tau, base_wrench},
              Overloads::gravity_and_external},
         .program = {by<inverse_dynamics_with_contacts>, Search::cheapest}},
        {.name = "constrained_inverse_dynamics",
         .of = Of::contacts,
         .exists = is_floating,
         .summary =
             {"Joint forces tau and wrenches f of the contacts on the robot for joint and base accelerations, with the "
              "smallest sum of f^2 / weights; `weights`: one per row, not negative, zero for an open contact.",
              "`regularization` r: zero, if the contacts can support the base in all directions; a positive r is added "
              "to the diagonal of the 6 x 6 system, and `base_wrench` is the wrench that the base then still needs.",
              kContactRows, kBase},
         .signature =
             {{q,
               qd,
               qdd,
               base_velocity,
               base_acceleration,
               {"weights", Role::contact_compliance, contact_rows},
               {"regularization", Role::contact_compliance, rows<1>}},
              {tau, contact_wrenches, base_wrench},
              Overloads::gravity_and_external},
         .program = {by<constrained_inverse_dynamics>, Search::cheapest}},
        {.name = "minimum_torque_inverse_dynamics",
         .of = Of::contacts,
         .exists = is_floating,
         .summary =
             {"constrained_inverse_dynamics with the smallest sum of torque_weights tau^2 + f^2 / weights (Righetti et "
              "al. 2013); `torque_weights`: one per joint, not negative.",
              kContactRows, kBase},
         .signature =
             {{q,
               qd,
               qdd,
               base_velocity,
               base_acceleration,
               {"weights", Role::contact_compliance, contact_rows},
               {"torque_weights", Role::contact_compliance, coordinates},
               {"regularization", Role::contact_compliance, rows<1>}},
              {tau, contact_wrenches, base_wrench},
              Overloads::gravity_and_external},
         .program = {by<minimum_torque_inverse_dynamics>, Search::cheapest}}}},
      {"constrained_forward_dynamics_derivatives",
       {{.name = "constrained_forward_dynamics_derivatives",
         .of = Of::contacts,
         .summary =
             {"constrained_forward_dynamics, and the partial derivatives of its results (Carpentier and Mansard 2018): "
              "a column for each joint's position (d_q), velocity (d_qd) and force (d_tau), and for each row of "
              "`contact_acceleration` (d_contact_acceleration). Rows: accelerations of {floating? the base, }then of "
              "the joints, then the contact wrenches.",
              kSwitches,
              "{floating? Columns of the base: by its velocity (d_base_velocity), and a rotation of the base about its "
              "own axes (d_base_rotation); gravity is fixed in the world and changes in base coordinates. Wrenches and "
              "`contact_acceleration` have components in base axes, which turn with the base.}",
              kContactRows, kBase},
         .signature =
             {{q, qd, tau, base_velocity, contact_acceleration, active, compliance},
              {qdd, base_acceleration, contact_wrenches, d("d_q", coordinates), d("d_qd", coordinates),
               d("d_tau", coordinates), d("d_base_rotation", rows<3>, is_floating),
               d("d_base_velocity", rows<6>, is_floating), d("d_contact_acceleration", contact_rows)},
              Overloads::gravity_and_external},
         .program = {by<constrained_forward_dynamics_derivatives>, Search::inverse_dynamics_derivatives},
         .remarks = {kConstantWrenches},
         .in_columns =
             ColumnForm{operations, are_better_in_columns, by<constrained_forward_dynamics_derivatives_in_columns>}},
        {.name = "impact_derivatives",
         .of = Of::contacts,
         .summary =
             {"impact, and the partial derivatives of its results: a column for each joint's position (d_q) and "
              "velocity (d_qd){floating? , for the velocity of the base (d_base_velocity)} before the impact, and for "
              "each contact's restitution (d_restitution). Rows: velocities of {floating? the base, }then of the "
              "joints, after the impact, then the impulses.",
              kSwitches, kContactRows, kBase},
         .signature =
             {{q, qd, base_velocity, restitution, active, compliance},
              {qd_after, base_velocity_after, contact_impulses, d("d_q", coordinates), d("d_qd", coordinates),
               d("d_base_velocity", rows<6>, is_floating), d("d_restitution", contact_count)}},
         .program = {by<impact_derivatives>, Search::inverse_dynamics_derivatives},
         .in_columns = ColumnForm{operations, are_better_in_columns, by<impact_derivatives_in_columns>}}}},
      {"operational_space",
       {{.name = "operational_space",
         .of = Of::contacts,
         .summary =
             {"The contact frames as a task (Khatib 1987): `inertia` = (J H^-1 J^T)^-1; `inverse` = H^-1 J^T inertia, "
              "the dynamically consistent inverse of J; `projector` = 1 - inverse J, whose transpose removes from "
              "joint forces the part that accelerates the task.",
              kSwitches, "Rows: {contacts}, in the order of the contact functions."},
         .signature =
             {{q, active, compliance},
              {matrix("inertia", contact_rows, contact_rows), matrix("inverse", velocities, contact_rows),
               matrix("projector", velocities, velocities)}},
         .program = {by<operational_space>, Search::inertia}}}}};
}

}  // namespace robcogen::algorithm::catalogue
