// Drives and limits of joints, from robot documents to the model.
#pragma once

#include <optional>

#include "import/parameters.h"
#include "language/kinematics/document.h"
#include "model/description.h"

namespace robcogen::import {

// Fills in drive and limits. Values of the drive are dynamics quantities; reports limits that depend on a parameter.
void describe_drive(
    const language::kinematics::Drive& drive,
    const std::optional<language::kinematics::Rotor>& rotor,
    const language::kinematics::Limits& limits,
    QuantityReader& reader,
    Diagnostics& diagnostics,
    model::DescribedJoint& described);

}  // namespace robcogen::import
