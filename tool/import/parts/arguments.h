// The arguments that an instance of a part gives to the parameters of the part.
#pragma once

#include <cstddef>
#include <memory>

#include "import/parts/rewrite.h"

namespace robcogen::import::parts {

// Returns the meanings of the names in the part, whose text begins at `offset` of `source`. Reports arguments that
// match no parameter, arguments that are given twice, and missing arguments.
Meanings meanings_of(
    const Entry& entry,
    const kinematics::Instance& instance,
    std::size_t offset,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::parts
