// Drives and limits of joints, from robot documents to the model.
#pragma once

#include <optional>
#include <vector>

#include "import/parameters.h"
#include "language/kinematics/document.h"
#include "model/description.h"

namespace robcogen::import {

// Those that are given, in the order of the document.
std::vector<language::ExpressionPtr> expressions_of_drive(
    const language::kinematics::Drive& drive,
    const std::optional<language::kinematics::Rotor>& rotor,
    const language::kinematics::Limits& limits);

// Fills in drive and limits. Values of the drive are dynamics quantities; reports limits that depend on a parameter.
void describe_drive(
    const language::kinematics::Drive& drive,
    const std::optional<language::kinematics::Rotor>& rotor,
    const language::kinematics::Limits& limits,
    QuantityReader& reader,
    Diagnostics& diagnostics,
    model::DescribedJoint& described);

}  // namespace robcogen::import
