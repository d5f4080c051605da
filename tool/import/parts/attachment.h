// A part joins the link that it is attached to.
#pragma once

#include <memory>
#include <vector>

#include "import/parts/assembly.h"

namespace robcogen::import::parts {

// The elements of the part, which has its final names, at its place on the link: its roots become `children` of the
// link, and the base of a robot becomes one of them or, unless the instance keeps it, part of the link. Reports `keep`
// for a part without a base, and two rotations that parameters keep from being written as one.
kinematics::Body join_to_link(
    Assembly part,
    const kinematics::Instance& instance,
    kinematics::Link& link,
    std::vector<kinematics::Child>& children,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::parts
