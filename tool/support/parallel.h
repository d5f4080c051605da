// A parallel loop.
#pragma once

#include <cstddef>
#include <functional>

namespace robcogen {

// Calls f(0) to f(count - 1), each once, in any order, on all cores that this process may use. Returns when all calls
// have ended. If calls threw exceptions, it rethrows that of the lowest index.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& f);

}  // namespace robcogen
