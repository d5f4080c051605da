// Checks of a robot beyond its tree structure.
#pragma once

#include "model/description.h"

namespace robcogen::model {

// Warns about ids that two links share, about gaps between ids, and about a child whose id is smaller than the id of
// its parent. Ids have no other effect.
void check_link_ids(const Description& description, Diagnostics& diagnostics);

// Warns, with the numbers, about a negative or zero mass, and about impossible moments of inertia: negative about some
// axis through the centre of mass, or one larger than the sum of the other two. Parameters have their default values.
// Properties that depend on parameters without one are not checked, nor are those of a fixed base, which are not used.
void check_mass_properties(const Description& description, Diagnostics& diagnostics);

// Reports negative drive values, by the default values of parameters, and impossible limits.
void check_drives(const Description& description, Diagnostics& diagnostics);

// Finds every joint (and the floating base) whose motion meets no inertia in any position, so that the joint-space
// inertia matrix has no inverse anywhere. Parameters have generic values.
InertiaDefects inertia_defects(const KinematicTree& tree);

// Warns, with the names of the joints, that functions which divide by the inertia matrix are not available; notes a
// robot without mass properties.
void report_inertia_defects(const KinematicTree& tree, Diagnostics& diagnostics);

// The codes of these reports.
const std::vector<std::string>& inertia_defect_codes();

}  // namespace robcogen::model
