// Where the lines of a function load and store blocks.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "symbolic/blocks.h"

namespace robcogen::backend {

struct BlockPlan {
  std::vector<symbolic::Block> loads;
  symbolic::Stores stores;
  std::map<std::size_t, std::size_t> load_at;                         // first statement of the columns -> load
  std::multimap<std::size_t, std::size_t> store_after;                // last statement of the columns -> block
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> loaded;  // statement -> load, column
  std::vector<bool> is_column;                                        // by statement: it is a column of a stored block
  std::vector<std::vector<bool>> is_stored;                           // by output and element: by a block or a fill
};

BlockPlan block_plan(const symbolic::Program& program);

}  // namespace robcogen::backend
