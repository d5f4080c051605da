// Drives and limits of joints, and where loops are assembled, from robot documents to the model.
#pragma once

#include "import/parameters.h"
#include "language/kinematics/document.h"
#include "model/description.h"

namespace robcogen::import {

// Values of the drive are dynamics quantities; reports limits, and positions in which loops are assembled, that depend
// on a parameter.
void describe_drive(
    const language::kinematics::DriveAndLimits& given,
    QuantityReader& reader,
    Diagnostics& diagnostics,
    model::DescribedJoint& described);

}  // namespace robcogen::import
