// Many independent things at the same time.
#pragma once

#include <cstddef>
#include <functional>

namespace robcogen {

// Calls f(0) to f(count - 1), each once, in any order and on all cores that this process may use. Returns when all are
// done; of the exceptions that calls threw it then throws that of the first index.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& f);

}  // namespace robcogen
