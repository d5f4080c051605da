// Converts the drives and limits of joints, and the positions in which loops are assembled, from robot documents to the
// model.
#pragma once

#include "import/parameters.h"
#include "language/kinematics/document.h"
#include "model/description.h"

namespace robcogen::import {

// Reads the drive as parameters of the dynamics. Reports limits, and positions in which loops are assembled, that
// depend on a parameter.
void describe_drive(
    const language::kinematics::DriveAndLimits& given,
    QuantityReader& reader,
    Diagnostics& diagnostics,
    model::DescribedJoint& described);

}  // namespace robcogen::import
