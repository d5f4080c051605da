// Classes of characters in documents, which are ASCII outside comments, and the detection of UTF-16.
#pragma once

#include <string_view>

namespace robcogen::language {

inline bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
inline bool is_word(char c) {
  return is_letter(c) || is_digit(c);
}
inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}
inline bool is_symbol(char c) {
  constexpr std::string_view symbols = "{}()[]=,:+-*/<>~";
  return symbols.find(c) != std::string_view::npos;
}

// Detects UTF-16 by its byte order mark, or by a zero in one of the first two bytes.
inline bool is_utf16(std::string_view text) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
  return text.size() > 1 && (text[0] == '\0') != (text[1] == '\0');
}

}  // namespace robcogen::language
