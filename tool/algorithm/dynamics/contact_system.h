// Contacts that are active or open, in the equations of motion.
#pragma once

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
      : rows(robot.trace, q, contacts),
        system(robot, rows),
        active(robot.trace, rows, system.inverse_inertia(), switches) {}

  SwitchedContacts(const SwitchedContacts&) = delete;
  SwitchedContacts& operator=(const SwitchedContacts&) = delete;

  ContactRows rows;
  ConstraintSystem system;
  ActiveContacts active;
};

}  // namespace robcogen::algorithm
