// Turns tendons that refer to joints by name into tendons over joints.
#pragma once

#include <vector>

#include "model/description.h"
#include "model/name_index.h"

namespace robcogen::model {

// Reports undeclared and spherical joints, names that are used twice, tendons without joints, and negative stiffness or
// damping; if `joints_repeat`, undeclared joints are not reported. A tendon with an error is left out.
std::vector<Tendon> resolve_tendons(
    const Description& description,
    NameIndex& joints,
    bool joints_repeat,
    Diagnostics& diagnostics);

}  // namespace robcogen::model
