// Pieces of a document's text: functions that find the end of a piece from its beginning.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robcogen::language {

// Returns zero beyond the end.
inline char character(std::string_view text, std::size_t at) {
  return at < text.size() ? text[at] : '\0';
}

std::size_t end_of_line(std::string_view text, std::size_t at);
// Returns the end of a word of letters and digits.
std::size_t end_of_word(std::string_view text, std::size_t at);

// Whether `//` or `/*` is here.
bool begins_comment(std::string_view text, std::size_t at);
// Returns the offset after `*/`, or of the end of the line; npos if `*/` is missing.
std::size_t end_of_comment(std::string_view text, std::size_t begin);

// Returns the offset after the second quote of `"…"` on one line; npos if there is no such text.
std::size_t end_of_quoted(std::string_view text, std::size_t begin);

// A number: digits, point, exponent. A name that follows without a blank multiplies it (`2.0a`), unless the text reads
// like a number in another language.
struct NumberText {
  std::size_t end = 0;
  bool is_malformed = false;
  std::string hint = {};  // what to write instead if malformed; empty if unknown
};
NumberText number_text(std::string_view text, std::size_t begin);

// Returns the end of a run of bytes of which none but the first may be part of a token.
std::size_t end_of_stray_run(std::string_view text, std::size_t begin);

}  // namespace robcogen::language
