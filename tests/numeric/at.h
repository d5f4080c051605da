// Elements of containers by the indices of the model, which are signed.
#pragma once

#include <cstddef>

namespace robcogen::numeric {

inline std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

}  // namespace robcogen::numeric
