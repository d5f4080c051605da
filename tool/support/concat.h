// Concatenation of texts.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen {

// Needs a single allocation; `+` of many pieces needs several.
inline std::string concat(std::initializer_list<std::string_view> pieces) {
  std::size_t size = 0;
  for (const std::string_view piece : pieces) size += piece.size();
  std::string result;
  result.reserve(size);
  for (const std::string_view piece : pieces) result += piece;
  return result;
}

inline std::string joined(const std::vector<std::string>& items, const std::string& separator = ", ") {
  std::string result;
  for (std::size_t i = 0; i < items.size(); ++i) result += (i > 0 ? separator : "") + items[i];
  return result;
}

// Replaces every occurrence of `old` by `with`.
inline std::string replaced(std::string text, std::string_view old, std::string_view with) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + with.size()))
    text.replace(at, old.size(), with);
  return text;
}

}  // namespace robcogen
