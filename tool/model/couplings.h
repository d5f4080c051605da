// Turns couplings that refer to joints by name into couplings over independent joints.
#pragma once

#include "model/description.h"
#include "model/name_index.h"

namespace robcogen::model {

// Resolves chains of couplings exactly. Reports undeclared joints, joints that are coupled twice, and cycles; if
// `joints_repeat`, undeclared joints are not reported. Returns no couplings if an error was reported.
std::vector<Coupling> resolve_couplings(
    const Description& description,
    NameIndex& joints,
    bool joints_repeat,
    Diagnostics& diagnostics);

}  // namespace robcogen::model
