// Turns loops that refer to frames and joints by name into loops of a tree and joints that follow others.
#pragma once

#include "model/description.h"

namespace robcogen::model {

// Adds the loops of a description to a tree, and determines which joints follow which, and how. The tree has no
// spherical components yet, and its other couplings are resolved. Reports ends that do not exist or are on one link,
// loops that do not close where they are assembled, are stretched there, or remove more motions than their joints have,
// and joints that cannot be independent.
void resolve_loops(const Description& description, KinematicTree& tree, Diagnostics& diagnostics);

// Returns the tree with all loops cut and all couplings removed, so that each joint moves independently. Loops stay
// listed.
KinematicTree with_free_joints(const KinematicTree& tree);

}  // namespace robcogen::model
