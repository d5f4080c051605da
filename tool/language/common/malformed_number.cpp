#include "language/common/malformed_number.h"

#include <fmt/format.h>

#include <algorithm>

#include "language/common/characters.h"

namespace robcogen::language {

std::size_t end_of_malformed_number(std::string_view text, std::size_t at) {
  const auto at_sign = [&] {
    const char before = text[at - 1];
    return (before == 'e' || before == 'E') && (text[at] == '+' || text[at] == '-');
  };
  while (at < text.size() && (is_word(text[at]) || text[at] == '.' || at_sign())) ++at;
  return at;
}

std::string hint_to_malformed_number(std::string_view number, std::string_view rest, bool has_exponent) {
  const auto end = std::find_if_not(rest.begin(), rest.end(), is_word);
  const std::string_view word = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
  if (word.empty()) return "";
  const std::string_view tail = word.substr(1);
  const bool counts = !tail.empty() && std::all_of(tail.begin(), tail.end(), is_digit);
  const auto begins_with = [&](char letter) { return (word[0] | 0x20) == letter; };
  if (number == "0" && (begins_with('x') || (begins_with('b') && counts))) return "write the number in base ten";
  const std::size_t not_underscore = std::min(word.find_first_not_of('_'), word.size());
  if (not_underscore > 0 && (not_underscore == word.size() || is_digit(word[not_underscore])))
    return "write digits without separators";
  const std::string product = fmt::format("'{0} {1}' for {0} times '{1}'", number, word);
  if (begins_with('e') && tail.empty()) return fmt::format("write digits after the '{}', or {}", word, product);
  if (begins_with('e') && counts && has_exponent) return "write one exponent";
  if (begins_with('d') && counts) return fmt::format("write '{}e{}' for a power of ten, or {}", number, tail, product);
  if (begins_with('f') && tail.empty()) return fmt::format("write '{}', or {}", number, product);
  return "";
}

}  // namespace robcogen::language
