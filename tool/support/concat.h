// Concatenation of texts with a single allocation; `+` of many pieces needs several.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace robcogen {

inline std::string concat(std::initializer_list<std::string_view> pieces) {
  std::size_t size = 0;
  for (const std::string_view piece : pieces) size += piece.size();
  std::string result;
  result.reserve(size);
  for (const std::string_view piece : pieces) result += piece;
  return result;
}

}  // namespace robcogen
