// How the joints between the base and a contact frame move it, and how its velocity and acceleration change with their
// motion. All vectors are in base axes, their rates those in an inertial frame.
//
// The position of a joint moves the contact point p by the field l + s x (p - o): s and l are the angular and linear
// part of the joint's motion subspace, o is a point on its axis that is fixed in the link before it, as s and l are. So
// the velocity and the acceleration of p change by the first and second rate of that field (Featherstone 2008, ch. 2).
// By the velocity of a joint, the acceleration changes by twice the first rate. Two axes of one spherical joint do not
// commute: by velocity, s turns with the mean of the velocities before and behind that joint.
#pragma once

#include <array>
#include <vector>

#include "algorithm/dynamics/contact_rows.h"

namespace robcogen::algorithm {

// The motion of the contact frame by one joint: angular, and of its origin.
struct ContactColumn {
  int joint = 0;
  int first = 0;  // the joint itself, or the first component of its spherical joint
  Motion column;  // of the Jacobian
  Motion velocity_by_position;
  Motion acceleration_by_position;
  Motion acceleration_by_velocity;
};

struct ContactMotion {
  std::vector<ContactColumn> columns;  // from the base to the contact
  Vector3 position;                    // of the frame's origin
  // By the angular velocity of the base about each of its axes, at a given spatial acceleration of the base.
  std::array<Motion, 3> acceleration_by_base_velocity;
};

// `in`: positions, velocities and accelerations by joint, velocity and acceleration of the base.
ContactMotion contact_motion(Trace& trace, const StateInputs& in, const model::Frame& frame);
std::vector<ContactMotion> contact_motions(Trace& trace, const StateInputs& in, const ContactFrames& contacts);

// The rows of all contacts from these motions.
ContactRows contact_rows(Trace& trace, const ContactFrames& contacts, const std::vector<ContactMotion>& motions);

// A column over the rows of the contacts for each coordinate, from one part of each ContactColumn.
Columns by_coordinate(
    Trace& trace,
    const ContactFrames& contacts,
    const std::vector<ContactMotion>& motions,
    Motion ContactColumn::*part);

// The derivatives of J^T f by the positions of the coordinates, for forces that are constant in base axes. `f`: by row
// of the contacts.
Columns generalized_force_derivatives(
    Trace& trace,
    const ContactFrames& contacts,
    const std::vector<ContactMotion>& motions,
    const std::vector<Expression>& f);

}  // namespace robcogen::algorithm
