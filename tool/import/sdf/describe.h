// Converts a document to the description of a model.
#pragma once

#include "import/sdf/names.h"

namespace robcogen::import::from_sdf {

// - The base is the root of the tree, or the world.
// - Links on fixed joints are part of the link that carries them. Fixed links have no mass properties.
// - A joint with two axes becomes two joints, with a massless link between them.
// - Joints that close loops become loops between two user frames, `<joint>_parent` and `<joint>_child`.
// Reports mass properties that SDF would compute, and couplings to joints that do not move. Warns about mass properties
// that the file does not give, and about forces of joints that close loops.
model::Description describe(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const SdfOptions& options,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_sdf
