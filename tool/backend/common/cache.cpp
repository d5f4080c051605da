#include "backend/common/cache.h"

namespace robcogen::backend {

std::vector<CachePart> cache_parts(const Library& library) {
  std::vector<CachePart> parts;
  int begin = 0;
  for (const Function& update : library.updates) {
    const int size = update.program.outputs.front().rows;
    parts.push_back({begin, size});
    begin += size;
  }
  return parts;
}

int cache_size(const Library& library) {
  if (library.updates.empty()) return 0;
  const CachePart last = cache_parts(library).back();
  return last.begin + last.size;
}

}  // namespace robcogen::backend
