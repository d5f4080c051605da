#include "language/common/stray_character.h"

#include <fmt/format.h>

#include "language/common/characters.h"

namespace robcogen::language {
namespace {

// Whether only blanks precede the character in its line.
bool begins_line(std::string_view text, std::size_t at) {
  const std::size_t last = text.substr(0, at).find_last_not_of(" \t");
  return last == std::string_view::npos || text[last] == '\n' || text[last] == '\r';
}

}  // namespace

StrayCharacter stray_character(std::string_view text, Span run) {
  const auto byte = static_cast<unsigned char>(text[run.begin]);
  if (byte >= 0x80) {
    return {"unexpected character outside ASCII", "names consist of A-Z, a-z, 0-9 and '_'; comments may hold any text"};
  }
  if (byte <= 0x20 || byte == 0x7f) return {fmt::format("unexpected byte 0x{:02x}", byte), ""};
  StrayCharacter found = {fmt::format("unexpected character '{}'", text[run.begin]), ""};
  if (byte == '#' || (byte == ';' && begins_line(text, run.begin))) {
    found.hint = "a comment begins with '//'";
    found.begins_comment = true;
  } else if (byte == ';') {
    found.hint =
        "items need no separator; ',' separates components and the names in a list; a comment begins with '//'";
  } else if (byte == '^' && run.end < text.size() && is_word(text[run.end])) {
    found.hint = "write a power as a product; '^' is allowed only before a name that is a keyword";
  }
  return found;
}

}  // namespace robcogen::language
