// Functions of contacts.
#include "algorithm/catalogue/groups.h"
#include "algorithm/catalogue/overloads.h"
#include "symbolic/count.h"

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
    "`active`: 1 where a contact holds, 0 where it is open. `compliance` (by row) is added to the diagonal of W: zero "
    "for "
    "rigid contacts, whose rows must be independent; a small number lets redundant ones share the load.";

// The common data of the functions of one list.
struct Contacts {
  const KinematicTree& tree;
  const ContactFrames& contacts;
  FormulationChoices& choices;
  std::string rows =
      "Contacts: " + names_of(contacts) +
      ". Rows have this order: velocities (m/s) or forces (N) of a point; of a surface angular velocities "
      "or moments first. In base axes, about the origin of the contact frame.";
  std::string base = "All that concerns the base is in base coordinates, angular first.";

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
      {"What is added to J times " + accelerations +
       " in the accelerations of the contact frames in an inertial frame."},
      contact_bias(tree, frames, "contact_bias"));
  contacts.add(
      list, "inverse_contact_inertia",
      {"W = J H^-1 J^T: accelerations of the contact frames by unit wrenches at them; structural zeros are literal "
       "(Featherstone 2008, sec. 8.4)."},
      inverse_contact_inertia(tree, frames, "inverse_contact_inertia", inertia), inertia);
  contacts.add_with_loads(
      list, "constrained_forward_dynamics",
      {"Accelerations from joint forces tau, and the wrenches of the contacts on the robot, where active contacts "
       "accelerate by `contact_acceleration`: zero, or -2 a velocity - a^2 error to remove an error of position "
       "(Baumgarte 1972).",
       kSwitches},
      constrained_forward_dynamics);
  contacts.add(
      list, "impact",
      {"Velocities after an impact at active contacts, which leave with -restitution times their velocity, and "
       "impulses "
       "(N s) of the contacts on the robot; `restitution` by contact.",
       kSwitches},
      impact(tree, frames, "impact", inertia), inertia);
  contacts.add_with_loads(
      list, "inverse_dynamics_with_contacts",
      {std::string("Joint forces tau") +
       (tree.floating_base ? " and the wrench on the base that is still missing" : "") +
       " for accelerations and given wrenches of the contacts on the robot."},
      inverse_dynamics_with_contacts);
  if (!tree.floating_base) return list;
  contacts.add_with_loads(
      list, "constrained_inverse_dynamics",
      {"Joint forces tau and wrenches f of the contacts on the robot for joint and base accelerations, with the "
       "smallest "
       "sum of f^2 / weights; `weights` by row, not negative: zero where a contact is open.",
       "`regularization` r: zero, where the contacts can hold the base in all directions; a positive r is added to the "
       "diagonal of the 6 x 6 system, and `base_wrench` is what is then missing."},
      constrained_inverse_dynamics);
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
        "dynamically consistent inverse of J; `projector` = 1 - inverse J, whose transpose leaves of joint forces what "
        "does not accelerate the task.",
        kSwitches, "Rows: " + names_of(contacts) + "; as functions of contacts have them."},
       {},
       {},
       operational_space(tree, contacts, "operational_space", formulation)}};
  add_method(list, "operational_space", description(tree, formulation.frames));
  return list;
}

}  // namespace robcogen::algorithm
