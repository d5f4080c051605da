// Adds what closes or couples the tree of bodies to its description.
#pragma once

#include "import/mjcf/describe.h"

namespace robcogen::import::from_mjcf {

// The link that a body belongs to, and its pose in the frame of that link.
struct Carried {
  int link = -1;  // index into the links, where [0] is the base; -1 if the body is not part of the robot
  Pose pose;
};

// Adds loops and the frames of their ends, actuators between sites, the joints that actuators and springs drive, and
// the positions in which loops are assembled: those of the `key` if the document has one, or else those that are drawn.
void add_loops(
    const Document& document,
    const Identifiers& identifiers,
    const std::vector<Carried>& carried,
    model::Description& description);

// Warns about joints of loops that are drawn outside their ranges, where loops may be assembled to the wrong side.
void check_drawn_loops(const Document& document, Diagnostics& diagnostics);

// Adds couplings for relations between fixed tendons. Reports joints that are not declared, and relations that
// determine no joint; warns about those that the robot has a part of only.
void add_tendon_couplings(
    const Document& document,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics);

// Adds the fixed tendons that have springs or dampers; those of copies are repeated for each copy. Reports joints that
// are not declared; warns about tendons that the robot has a part of only.
void add_tendons(
    const Document& document,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
