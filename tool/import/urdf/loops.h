// The phases of `add_loops`, each of which adds to a description. Joints and links are those of the document, by index.
#pragma once

#include <set>
#include <vector>

#include "import/urdf/describe.h"

namespace robcogen::import::from_urdf {

// Whether each joint may follow: those with `independent="false"` if there are any, otherwise all but those with
// `independent="true"`. The others lead the loops that they are part of.
std::vector<bool> may_follow(const Document& document);

// Loops, and user frames at their ends. Returns the joints that are part of them.
std::set<int> add_loop_joints(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics);

// A coupling for each joint that follows by those of the document.
void add_couplings(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const std::vector<bool>& may_follow,
    model::Description& description,
    Diagnostics& diagnostics);

// The joints that lead loops and are not coupled. Reports those that are said to follow, but do not.
void add_independents(
    const Document& document,
    const Identifiers& identifiers,
    const std::vector<bool>& may_follow,
    const std::set<int>& joints_of_loops,
    model::Description& description,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
