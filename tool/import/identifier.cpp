#include "import/identifier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace robcogen::import {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_legal(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}

// The code point of the character that begins at this byte, and its length in bytes; the length is zero if the bytes
// are not UTF-8 (RFC 3629).
struct Character {
  std::uint32_t code = 0;
  std::size_t length = 0;
};

Character character_at(std::string_view text, std::size_t begin) {
  const auto byte = [&](std::size_t k) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[k])); };
  const std::uint32_t first = byte(begin);
  const std::size_t length = first < 0x80U   ? 1
                             : first < 0xC2U ? 0
                             : first < 0xE0U ? 2
                             : first < 0xF0U ? 3
                             : first < 0xF5U ? 4
                                             : 0;
  if (length == 0 || begin + length > text.size()) return {};
  std::uint32_t code = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(begin + k) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte(begin + k) & 0x3FU);
  }
  return {code, length};
}

}  // namespace

std::string identifier(const std::string& name) {
  std::string result;
  if (!name.empty() && is_digit(name.front())) result += '_';
  for (std::size_t i = 0; i < name.size();) {
    const Character character = character_at(name, i);
    if (is_legal(name[i])) {
      result += name[i];
    } else if (character.length > 1) {
      result += fmt::format("u{:04X}", character.code);
    } else {
      result += '_';
    }
    i += std::max<std::size_t>(character.length, 1);
  }
  return result;
}

bool is_beyond_ascii(const std::string& name) {
  return std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80U; });
}

}  // namespace robcogen::import
