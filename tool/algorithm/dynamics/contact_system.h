// Contacts that are active or open, in the equations of motion.
#pragma once

#include <utility>
#include <vector>

#include "algorithm/dynamics/constraint_system.h"
#include "algorithm/dynamics/contact_rows.h"

namespace robcogen::algorithm {

// The inputs that switch contacts and make them compliant.
struct ContactSwitches {
  // Declares the inputs `active`, an element per contact, and `compliance`, an element per row.
  ContactSwitches(Trace& trace, const ContactFrames& contacts);

  std::vector<Expression> active, compliance;
};

// A linear system for the wrenches at active contacts, (W + compliance) f = b. Where `active` is 0, the contact is
// decoupled from the others, and the identity is added to its own block, which is then regular whatever W is.
class ActiveContacts {
 public:
  ActiveContacts(Trace& trace, const ContactRows& rows, const SquareMatrix& W, const ContactSwitches& switches);

  // The factor of the matrix, and by row whether its contact is active.
  LdlFactors factors() const { return ldl_factors(matrix_, rows_.names); }
  std::vector<Expression> activity() const;
  // The wrenches; exactly zero for contacts that are not active.
  std::vector<Expression> wrenches(std::vector<Expression> b) const;
  // The inverse of the matrix; rows and columns of contacts that are not active are zero.
  SquareMatrix inverse() const;

 private:
  Trace& trace_;
  const ContactRows& rows_;
  const ContactSwitches& switches_;
  SquareMatrix matrix_;
};

// A robot's contacts, some of them active.
struct SwitchedContacts {
  SwitchedContacts(
      const TracedRobot& robot,
      const std::vector<Expression>& q,
      const ContactFrames& contacts,
      const ContactSwitches& switches)
      : SwitchedContacts(robot, ContactRows(robot.trace, q, contacts), switches) {}
  SwitchedContacts(const TracedRobot& robot, ContactRows of_contacts, const ContactSwitches& switches)
      : rows(std::move(of_contacts)),
        system(robot, rows),
        active(robot.trace, rows, system.inverse_inertia(), switches) {}

  SwitchedContacts(const SwitchedContacts&) = delete;
  SwitchedContacts& operator=(const SwitchedContacts&) = delete;

  ContactRows rows;
  ConstraintSystem system;
  ActiveContacts active;
};

// The solution for given forces of the joints, by row of H and by row of the contacts. `bias`, `of_contacts`: forces
// and accelerations of the contact frames without accelerations of the coordinates.
struct ConstrainedMotion {
  std::vector<Expression> accelerations, wrenches;
};
ConstrainedMotion constrained_motion(
    Trace& trace,
    const SwitchedContacts& contacts,
    const std::vector<Expression>& tau,
    const Forces& bias,
    const std::vector<Expression>& of_contacts,
    const std::vector<Expression>& wanted);

// The change of the velocities in an impact, by row of H, and the impulses of the contacts. `restitution`: by contact.
struct ConstrainedImpact {
  std::vector<Expression> change, impulses;
};
ConstrainedImpact constrained_impact(
    Trace& trace,
    const SwitchedContacts& contacts,
    const std::vector<Expression>& before,
    const std::vector<Expression>& restitution);

// The velocities of the robot by row of H: base, then coordinates.
std::vector<Expression> stacked_velocities(const StateInputs& in, const Trace& trace);
// Outputs a motion by row of H as two arrays, one of the coordinates and one of a floating base.
struct NamedRole {
  const char* name;
  symbolic::Role role;
};
void output_motion(Trace& trace, const std::vector<Expression>& v, const NamedRole& joints, const NamedRole& base);

}  // namespace robcogen::algorithm
