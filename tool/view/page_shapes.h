// The shapes of links as data of a page.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "model/geometry.h"

namespace robcogen::view {

struct PageShapes {
  nlohmann::ordered_json shapes, meshes;
  std::size_t triangles = 0, shown_triangles = 0;  // of all meshes, in the files and on the page
};

// Each mesh is on the page once; all of them together have so few triangles that the page stays small and moves without
// delay.
PageShapes page_shapes(const std::vector<model::Shape>& shapes);

}  // namespace robcogen::view
