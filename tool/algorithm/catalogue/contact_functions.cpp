// Functions of contacts.
#include "algorithm/catalogue/groups.h"
#include "algorithm/catalogue/overloads.h"
#include "algorithm/catalogue/sizes.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm {

using model::KinematicTree;

namespace {

// `fr_LF_foot, fr_sole (surface)`
std::string names_of(const ContactFrames& contacts) {
  std::string names;
  for (const model::ContactFrame& contact : contacts)
    names += (names.empty() ? "" : ", ") + contact.frame.name + (contact.is_surface ? " (surface)" : "");
  return names;
}

// The existing formulation in which a program is cheapest.
Formulation cheapest_for(
    FormulationChoices& choices,
    const std::function<symbolic::Program(const Formulation&)>& trace) {
  const auto work = [&](Formulation formulation) {
    formulation.is_draft = true;
    formulation.representative.clear();
    return symbolic::work(trace(formulation));
  };
  const Formulation other = choices.cheaper_for(trace);
  return work(choices.inertia()) < work(other) ? choices.inertia() : other;
}

const char* const kSwitches =
    "`active`: 1 for an active contact, 0 for an open one. `compliance` (per row) is added to the diagonal of W: zero "
    "for rigid contacts, whose rows must be independent; a small number lets redundant contacts share the load.";

// The common data of the functions of one list.
struct Contacts {
  const KinematicTree& tree;
  const ContactFrames& contacts;
  FormulationChoices& choices;
  std::string rows = "Contacts: " + names_of(contacts) +
                     ". Rows are in this order: velocities (m/s) or forces (N) of a point; for a surface, angular "
                     "velocities or moments first. They are in base axes, about the origin of the contact frame.";
  std::string base = "All quantities of the base are in base coordinates, angular first.";

  std::vector<std::string> summary(std::vector<std::string> lines) const {
    lines.push_back(rows);
    if (tree.floating_base) lines.push_back(base);
    return lines;
  }

  void add(
      std::vector<RobotFunction>& list,
      const std::string& name,
      std::vector<std::string> lines,
      symbolic::Program program,
      const Formulation& formulation = {}) const {
    list.push_back({"contacts", "", name, summary(std::move(lines)), {}, {}, std::move(program)});
    add_method(list, name, description(tree, formulation.frames));
  }

  // Adds a function with overloads, all in the formulation that is cheapest for the first one.
  template <class Trace>
  void add_with_loads(
      std::vector<RobotFunction>& list,
      const std::string& name,
      std::vector<std::string> lines,
      const Trace& trace) const {
    const Formulation formulation = cheapest_for(
        choices, [&](const Formulation& f) { return trace(tree, contacts, name, default_loads(tree), f); });
    add_overloads(list, tree, "contacts", name, summary(std::move(lines)), [&](const std::string& kernel, Loads loads) {
      return trace(tree, contacts, kernel, loads, formulation);
    });
    add_method(list, name, description(tree, formulation.frames));
  }
};

}  // namespace

std::vector<RobotFunction> contacts_functions(
    const KinematicTree& tree,
    const ContactFrames& frames,
    FormulationChoices& choices) {
  const Contacts contacts{tree, frames, choices};
  const std::string accelerations =
      tree.floating_base ? "(spatial base acceleration, qdd)" : "the joint accelerations qdd";
  const Formulation& inertia = choices.inertia();
  std::vector<RobotFunction> list;
  contacts.add(
      list, "contact_jacobian",
      {"Jacobian J of the contacts: velocities of the contact frames in an inertial frame, a column for each "
       "coordinate "
       "of the joint-space inertia matrix."},
      contact_jacobian(tree, frames, "contact_jacobian"));
  contacts.add(
      list, "contact_velocity", {"Velocities of the contact frames: J times the velocities of the robot."},
      contact_velocity(tree, frames, "contact_velocity"));
  contacts.add(
      list, "contact_bias",
      {"Accelerations of the contact frames in an inertial frame minus J times " + accelerations + "."},
      contact_bias(tree, frames, "contact_bias"));
  contacts.add(
      list, "inverse_contact_inertia",
      {"W = J H^-1 J^T: accelerations of the contact frames due to unit wrenches on them; structural zeros are literal "
       "(Featherstone 2008, sec. 8.4)."},
      inverse_contact_inertia(tree, frames, "inverse_contact_inertia", inertia), inertia);
  contacts.add_with_loads(
      list, "constrained_forward_dynamics",
      {"Accelerations from joint forces tau, and the wrenches of the contacts on the robot: active contacts have the "
       "acceleration `contact_acceleration`, zero, or -2 a velocity - a^2 error to remove a position error (Baumgarte "
       "1972).",
       kSwitches},
      constrained_forward_dynamics);
  contacts.add(
      list, "impact",
      {"Velocities after an impact at active contacts, and impulses (N s) of the contacts on the robot: a contact "
       "leaves with -restitution times its velocity; `restitution` has one element per contact.",
       kSwitches},
      impact(tree, frames, "impact", inertia), inertia);
  contacts.add_with_loads(
      list, "inverse_dynamics_with_contacts",
      {std::string("Joint forces tau") + (tree.floating_base ? " and the wrench that the base still needs" : "") +
       " for accelerations and given wrenches of the contacts on the robot."},
      inverse_dynamics_with_contacts);
  if (!tree.floating_base) return list;
  contacts.add_with_loads(
      list, "constrained_inverse_dynamics",
      {"Joint forces tau and wrenches f of the contacts on the robot for joint and base accelerations, with the "
       "smallest sum of f^2 / weights; `weights`: one per row, not negative, zero for an open contact.",
       "`regularization` r: zero, if the contacts can support the base in all directions; a positive r is added to the "
       "diagonal of the 6 x 6 system, and `base_wrench` is the wrench that the base then still needs."},
      constrained_inverse_dynamics);
  return list;
}

std::vector<RobotFunction> constrained_forward_dynamics_derivatives_functions(
    const KinematicTree& tree,
    const ContactFrames& frames,
    FormulationChoices& choices) {
  const std::string group = "constrained_forward_dynamics_derivatives";
  const Contacts contacts{tree, frames, choices};
  const Formulation& formulation = choices.inverse_dynamics_derivatives();
  const std::string of_base = tree.floating_base ? "the base, " : "";
  std::vector<std::string> summary = {
      "constrained_forward_dynamics, and the partial derivatives of its results (Carpentier and Mansard 2018): a "
      "column "
      "for each joint's position (d_q), velocity (d_qd) and force (d_tau), and for each row of `contact_acceleration` "
      "(d_contact_acceleration). Rows: accelerations of " +
          of_base + "then of the joints, then the contact wrenches.",
      kSwitches};
  if (tree.floating_base)
    summary.emplace_back(
        "Columns of the base: by its velocity (d_base_velocity), and a rotation of the base about its own axes "
        "(d_base_rotation); gravity is fixed in the world and changes in base coordinates. Wrenches and "
        "`contact_acceleration` have components in base axes, which turn with the base.");
  std::vector<RobotFunction> list;
  add_overloads(list, tree, group, group, contacts.summary(summary), [&](const std::string& kernel, Loads loads) {
    return constrained_forward_dynamics_derivatives(tree, frames, kernel, loads, formulation);
  });
  add_wrenches_remark(list);
  list.push_back(
      {group,
       "",
       "impact_derivatives",
       contacts.summary(
           {"impact, and the partial derivatives of its results: a column for each joint's position (d_q) and velocity "
            "(d_qd)" +
                std::string(tree.floating_base ? ", for the velocity of the base (d_base_velocity)" : "") +
                " before the impact, and for each contact's restitution (d_restitution). Rows: velocities of " +
                of_base + "then of the joints, after the impact, then the impulses.",
            kSwitches}),
       {},
       {},
       impact_derivatives(tree, frames, "impact_derivatives", formulation)});
  const long operations = operations_of_contact_solutions(tree, frames);
  if (are_better_in_columns(operations))
    for (RobotFunction& f : list) {
      const std::string& name = f.program.name;
      f.solved = f.name == group ? constrained_forward_dynamics_derivatives_in_columns(
                                       tree, frames, name, loads_of(f.program), formulation)
                                 : impact_derivatives_in_columns(tree, frames, name, formulation);
      f.solved->is_long = are_long_solutions(operations);
    }
  for (const std::string& name : {group, std::string("impact_derivatives")})
    add_method(list, name, description(tree, formulation.frames));
  return list;
}

std::vector<RobotFunction> operational_space_functions(
    const KinematicTree& tree,
    const ContactFrames& contacts,
    FormulationChoices& choices) {
  const Formulation& formulation = choices.inertia();
  std::vector<RobotFunction> list = {
      {"operational_space",
       "",
       "operational_space",
       {"The contact frames as a task (Khatib 1987): `inertia` = (J H^-1 J^T)^-1; `inverse` = H^-1 J^T inertia, the "
        "dynamically consistent inverse of J; `projector` = 1 - inverse J, whose transpose removes from joint forces "
        "the part that accelerates the task.",
        kSwitches, "Rows: " + names_of(contacts) + ", in the order of the contact functions."},
       {},
       {},
       operational_space(tree, contacts, "operational_space", formulation)}};
  add_method(list, "operational_space", description(tree, formulation.frames));
  return list;
}

}  // namespace robcogen::algorithm
