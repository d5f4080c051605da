// From loops that refer to frames and joints by name to loops of a tree, and to joints that follow others.
#pragma once

#include "model/description.h"

namespace robcogen::model {

// Adds the loops of a description to a tree without spherical components, whose other couplings are resolved: which
// joints follow which, and how. Reports ends that do not exist or move together, loops that do not close at q = 0, that
// are stretched there or take away more than they have, and joints that cannot be independent.
void resolve_loops(const Description& description, KinematicTree& tree, Diagnostics& diagnostics);

// The tree in which loops are cut and couplings are open: each joint moves by itself. Loops stay listed.
KinematicTree with_free_joints(const KinematicTree& tree);

}  // namespace robcogen::model
