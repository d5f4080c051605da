// The equations of motion with contacts, H a + C = tau + J^T f, eliminated for the contact wrenches f.
#pragma once

#include <vector>

#include "algorithm/dynamics/contact_rows.h"
#include "algorithm/dynamics/ldl.h"
#include "algorithm/dynamics/ordered_inertia.h"

namespace robcogen::algorithm {

// With H = L^T D L and Y = L^-T J^T, W = J H^-1 J^T = Y^T D^-1 Y: only the first half of a solution is made for each
// row of J, along the ancestors of its coordinates. (Featherstone 2008, sec. 6.5 and 8.4.)
class ContactSystem {
 public:
  ContactSystem(const TracedRobot& robot, const ContactRows& rows);

  // The inverse inertia at the contacts; a pair of rows that share no coordinate has a literal zero.
  const SquareMatrix& inverse_inertia() const { return W_; }

  // Forces by row of H, as the following functions take them.
  std::vector<Expression> halved(const std::vector<Expression>& forces) const;
  // By row of the contacts: J H^-1 forces.
  std::vector<Expression> at_contacts(const std::vector<Expression>& halved) const;
  // H^-1 (forces + J^T wrenches).
  std::vector<Expression> accelerations(std::vector<Expression> halved, const std::vector<Expression>& wrenches) const;

 private:
  Trace& trace_;
  OrderedInertia inertia_;
  LdlFactors factors_;
  std::vector<std::vector<Expression>> Y_, per_d_;  // by row of the contacts; per_d = D^-1 Y
  SquareMatrix W_;
};

// What switches contacts and makes them soft.
struct ContactSwitches {
  // Declares the inputs `active`, an element a contact, and `compliance`, an element a row.
  ContactSwitches(Trace& trace, const ContactFrames& contacts);

  std::vector<Expression> active, compliance;
};

// A linear system for the wrenches at active contacts, (W + compliance) f = b. Where `active` is 0, the contact has no
// part in the others, and its own block gets the identity added: regular whatever W is.
class ActiveContacts {
 public:
  ActiveContacts(Trace& trace, const ContactRows& rows, const SquareMatrix& W, const ContactSwitches& switches);

  // Exactly zero where a contact is not active.
  std::vector<Expression> wrenches(std::vector<Expression> b) const;
  // Rows and columns of contacts that are not active are zero.
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
  ContactSystem system;
  ActiveContacts active;
};

}  // namespace robcogen::algorithm
