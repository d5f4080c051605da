// Couplings and tendons that refer to joints of instances, such as `leg.knee`; couplings possibly in loops over
// instances.
#pragma once

#include <string>
#include <vector>

#include "import/parts/assembly.h"

namespace robcogen::import::parts {

// Whether any coupling is in a loop, or couples a joint of an instance.
bool names_instances(const kinematics::Body& body);

// Replaces `instance.joint` by the name of the joint in the first `own` couplings and `own_tendons` tendons, and
// repeats the body of each loop for each of its instances. An instance is one of those listed, or a prefix of joint
// names, which serves as an instance. Reports unknown instances and joints, instances that a loop lists twice, and loop
// variables that have the name of an element.
void unroll_couplings(
    Assembly& assembly,
    std::size_t own,
    std::size_t own_tendons,
    const std::vector<std::string>& instances,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::parts
