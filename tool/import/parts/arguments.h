// What an instance of a part gives to the parameters of the part.
#pragma once

#include <cstddef>
#include <memory>

#include "import/parts/rewrite.h"

namespace robcogen::import::parts {

// The meanings of names in the part, whose text begins at `offset` of `source`. Reports arguments that the part has no
// parameter for, that are given twice, and that are missing.
Meanings meanings_of(
    const Entry& entry,
    const kinematics::Instance& instance,
    std::size_t offset,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::parts
