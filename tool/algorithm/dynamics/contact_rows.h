// Contacts as rows of constraints: how the coordinates move the contact frames.
#pragma once

#include <string>
#include <vector>

#include "algorithm/dynamics/constraint_system.h"
#include "algorithm/dynamics/newton_euler.h"
#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

using ContactFrames = std::vector<model::ContactFrame>;

// The rows of all contacts, in the order of the list and in base axes: for a surface the angular velocity and the
// velocity of the frame's origin, for a point the latter alone.
struct ContactRows : ConstraintRows {
  ContactRows(Trace& trace, const std::vector<Expression>& q, const ContactFrames& contacts);
  // The same from columns by coordinate, for each contact.
  ContactRows(const ContactFrames& contacts, const std::vector<std::vector<Motion>>& columns);

  std::vector<int> contact;  // by row
};

// The elements of a motion of a contact frame that are rows of this contact.
std::vector<Expression> elements_of(const model::ContactFrame& contact, const Motion& motion);

// Names of the elements of arrays over the rows: of velocities and accelerations, or of forces.
std::vector<std::string> motion_elements(const ContactFrames& contacts);
std::vector<std::string> force_elements(const ContactFrames& contacts);

// By row: the term that is added to J times the accelerations to give the acceleration of the contact frames. `motions`
// include gravity.
std::vector<Expression> contact_bias(
    const TracedRobot& robot,
    const std::vector<LinkMotion>& motions,
    const Vector3& gravity,
    const ContactFrames& contacts);

}  // namespace robcogen::algorithm
