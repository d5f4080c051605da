// Indices of joints, links and statements are ints; containers need std::size_t.
#pragma once

#include <cstddef>

namespace robcogen {

constexpr std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

}  // namespace robcogen
