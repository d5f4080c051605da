// The cache of a robot's parameters: the results of Library::updates, one after another.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend {

// The part of the cache that one update computes: `size` elements from `begin` on.
struct CachePart {
  int begin = 0, size = 0;
};

// The parts, in the order of Library::updates.
std::vector<CachePart> cache_parts(const Library& library);

int cache_size(const Library& library);

}  // namespace robcogen::backend
