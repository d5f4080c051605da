// From couplings that refer to joints by name to couplings over independent joints.
#pragma once

#include "model/description.h"
#include "model/name_index.h"

namespace robcogen::model {

// Resolves chains of couplings exactly. Reports joints that are not declared, joints that are coupled twice, and
// cycles; nothing about names where `joints_repeat`. Without couplings when an error was reported.
std::vector<Coupling> resolve_couplings(
    const Description& description,
    NameIndex& joints,
    bool joints_repeat,
    Diagnostics& diagnostics);

}  // namespace robcogen::model
