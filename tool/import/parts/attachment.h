// Attaches a part to a link.
#pragma once

#include <memory>
#include <vector>

#include "import/parts/assembly.h"

namespace robcogen::import::parts {

// Returns the elements of the part, which has its final names, placed on the link. The roots of the part become
// `children` of the link. The base of a robot becomes one of them if the instance keeps it, and otherwise part of the
// link. Reports `keep` for a part without a base, and two rotations that cannot be combined because of parameters.
kinematics::Body join_to_link(
    Assembly part,
    const kinematics::Instance& instance,
    kinematics::Link& link,
    std::vector<kinematics::Child>& children,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::parts
