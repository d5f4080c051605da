// The phases of `add_loops`, each of which adds to a description. Joints and links are indices into the document.
#pragma once

#include <set>
#include <vector>

#include "import/urdf/describe.h"

namespace robcogen::import::from_urdf {

// Tells for each joint whether it may follow: if any joints have `independent="false"`, only these may; otherwise all
// but those with `independent="true"`. The others are the independent joints of their loops.
std::vector<bool> may_follow(const Document& document);

// Adds loops, and user frames at their ends. Returns the joints that are part of them.
std::set<int> add_loop_joints(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics);

// Adds a coupling for each joint that follows others through the couplings of the document.
void add_couplings(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const std::vector<bool>& may_follow,
    model::Description& description,
    Diagnostics& diagnostics);

// Adds the independent joints of loops that are not coupled. Reports joints that are declared to follow but do not.
void add_independents(
    const Document& document,
    const Identifiers& identifiers,
    const std::vector<bool>& may_follow,
    const std::set<int>& joints_of_loops,
    model::Description& description,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
