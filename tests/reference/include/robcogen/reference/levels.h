// The processor levels of functions over many states that this machine can run.
#pragma once

#include <vector>

#include "robcogen/batch.h"

namespace robcogen::reference {

inline std::vector<batch::Level> available_levels() {
  std::vector<batch::Level> levels;
  for (const batch::Level level : {batch::Level::baseline, batch::Level::avx2, batch::Level::avx512})
    if (batch::available(level) == level) levels.push_back(level);
  return levels;
}

}  // namespace robcogen::reference
