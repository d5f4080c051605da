#include "support/texts.h"

#include <algorithm>

namespace robcogen {

std::string_view Texts::add(std::initializer_list<std::string_view> pieces) {
  constexpr std::size_t kBlock = 1 << 14;
  std::size_t size = 0;
  for (const std::string_view piece : pieces) size += piece.size();
  if (blocks_.empty() || blocks_.back().capacity() - blocks_.back().size() < size)
    blocks_.emplace_back().reserve(std::max(size, kBlock));
  std::string& block = blocks_.back();
  const std::size_t begin = block.size();
  for (const std::string_view piece : pieces) block += piece;
  return std::string_view(block).substr(begin);
}

}  // namespace robcogen
