#include "language/common/text_pieces.h"

#include <algorithm>
#include <utility>

#include "language/common/characters.h"
#include "language/common/malformed_number.h"

namespace robcogen::language {
namespace {

template <class Predicate>
std::size_t end_of(std::string_view text, std::size_t at, Predicate belongs) {
  while (at < text.size() && belongs(text[at])) ++at;
  return at;
}

}  // namespace

std::size_t end_of_line(std::string_view text, std::size_t at) {
  return std::min(text.find_first_of("\r\n", at), text.size());
}

std::size_t end_of_word(std::string_view text, std::size_t at) {
  return end_of(text, at, is_word);
}

bool begins_comment(std::string_view text, std::size_t at) {
  return character(text, at) == '/' && (character(text, at + 1) == '/' || character(text, at + 1) == '*');
}

std::size_t end_of_comment(std::string_view text, std::size_t begin) {
  if (text[begin + 1] == '/') return end_of_line(text, begin);
  const std::size_t end = text.find("*/", begin + 2);
  return end == std::string_view::npos ? end : end + 2;
}

std::size_t end_of_quoted(std::string_view text, std::size_t begin) {
  if (character(text, begin) != '"') return std::string_view::npos;
  const std::size_t end = text.find_first_of("\"\r\n", begin + 1);
  return character(text, end) == '"' ? end + 1 : std::string_view::npos;
}

NumberText number_text(std::string_view text, std::size_t begin) {
  std::size_t end = end_of(text, begin, is_digit);
  if (character(text, end) == '.') end = end_of(text, end + 1, is_digit);
  const char letter = character(text, end), next = character(text, end + 1);
  const std::size_t sign = next == '+' || next == '-' ? 1 : 0;
  const bool has_exponent = (letter == 'e' || letter == 'E') && is_digit(character(text, end + 1 + sign));
  if (has_exponent) end = end_of(text, end + 1 + sign, is_digit);
  std::string hint = hint_to_malformed_number(text.substr(begin, end - begin), text.substr(end), has_exponent);
  if (character(text, end) != '.' && hint.empty()) return {end};
  return {end_of_malformed_number(text, end), true, std::move(hint)};
}

std::size_t end_of_stray_run(std::string_view text, std::size_t begin) {
  return end_of(
      text, begin + 1, [](char c) { return !is_blank(c) && !is_word(c) && !is_symbol(c) && c != '^' && c != '$'; });
}

}  // namespace robcogen::language
