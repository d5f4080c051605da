// Couplings that name joints of instances, `leg.knee`, some of them in loops over instances.
#pragma once

#include <string>
#include <vector>

#include "import/parts/assembly.h"

namespace robcogen::import::parts {

// Whether a coupling stands in a loop, or is of a joint of an instance.
bool names_instances(const kinematics::Body& body);

// Puts the names of joints in place of `instance.joint` in the first `own` couplings, and the body of each loop once
// for each of its instances. An instance is one of those listed, or a prefix of names that serves as one. Reports
// unknown instances and joints, instances that a loop lists twice, and variables of loops with the name of an element.
void unroll_couplings(
    Assembly& assembly,
    std::size_t own,
    const std::vector<std::string>& instances,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::parts
