// Drives and limits of joints, and where loops are assembled, from robot documents to the model.
#pragma once

#include "import/parameters.h"
#include "language/kinematics/document.h"
#include "model/description.h"

namespace robcogen::import {

// Fills in what a joint, or one of its coordinates, says of them. Values of the drive are dynamics quantities; reports
// limits, and positions in which loops are assembled, that depend on a parameter.
void describe_drive(
    const language::kinematics::Joint& joint,
    QuantityReader& reader,
    Diagnostics& diagnostics,
    model::DescribedJoint& described);
void describe_drive(
    const language::kinematics::Coordinate& coordinate,
    QuantityReader& reader,
    Diagnostics& diagnostics,
    model::DescribedJoint& described);

}  // namespace robcogen::import
