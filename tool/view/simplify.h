// Triangle meshes for pictures.
#pragma once

#include <cstddef>

#include "model/geometry.h"

namespace robcogen::view {

// A mesh of about the same form with at most `limit` triangles, if it has more: the vertices in each cell of a grid
// become one, their mean (Rossignac and Borrel 1993). At least one triangle remains.
model::TriangleMesh simplified(const model::TriangleMesh& mesh, std::size_t limit);

}  // namespace robcogen::view
