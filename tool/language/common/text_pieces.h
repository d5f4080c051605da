// Pieces of a document's text: where each ends, from where it begins.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robcogen::language {

// Zero behind the end.
inline char character(std::string_view text, std::size_t at) {
  return at < text.size() ? text[at] : '\0';
}

std::size_t end_of_line(std::string_view text, std::size_t at);
// Of letters and digits.
std::size_t end_of_word(std::string_view text, std::size_t at);

// `//` and `/*`.
bool begins_comment(std::string_view text, std::size_t at);
// Behind its `*/`, or at the end of its line; npos where `*/` is missing.
std::size_t end_of_comment(std::string_view text, std::size_t begin);

// Behind the second quote of `"…"` in one line; npos where this is none.
std::size_t end_of_quoted(std::string_view text, std::size_t begin);

// Digits, point, exponent. A name that follows without a blank multiplies (`2.0a`), unless the text reads like a number
// of another language.
struct NumberText {
  std::size_t end = 0;
  bool is_malformed = false;
  std::string hint = {};  // what to write instead of a malformed one; empty where nobody knows
};
NumberText number_text(std::string_view text, std::size_t begin);

// Of a run of bytes of which none but the first may be part of a token.
std::size_t end_of_stray_run(std::string_view text, std::size_t begin);

}  // namespace robcogen::language
