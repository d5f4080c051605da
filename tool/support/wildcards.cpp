#include "support/wildcards.h"

#include <algorithm>

namespace robcogen {
namespace {

// Edits of the pattern's own characters that make it match the text. Wildcards cost nothing.
std::size_t edits_to_match(std::string_view pattern, std::string_view text) {
  // row[j]: edits for the pattern up to the current character, and the first j characters of the text.
  std::vector<std::size_t> row(text.size() + 1);
  for (std::size_t j = 0; j <= text.size(); ++j) row[j] = j;
  for (const char c : pattern) {
    std::size_t diagonal = row[0];
    if (c != '*') ++row[0];
    for (std::size_t j = 1; j <= text.size(); ++j) {
      const std::size_t above = row[j];
      if (c == '*') {
        row[j] = std::min(above, row[j - 1]);
      } else {
        const bool is_same = c == '?' || c == text[j - 1];
        row[j] = std::min({diagonal + (is_same ? 0 : 1), above + 1, row[j - 1] + 1});
      }
      diagonal = above;
    }
  }
  return row.back();
}

}  // namespace

bool has_wildcards(std::string_view pattern) {
  return pattern.find_first_of("*?") != std::string_view::npos;
}

bool matches(std::string_view pattern, std::string_view text) {
  // After a mismatch, the last `*` takes one more character; earlier ones never need to.
  std::size_t p = 0, t = 0, star = std::string_view::npos, taken = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::string nearest_to_pattern(const std::string& pattern, const std::vector<std::string>& texts) {
  constexpr std::size_t kLongest = 200;  // longer names are not worth the time
  const auto wildcards = static_cast<std::size_t>(
      std::count_if(pattern.begin(), pattern.end(), [](char c) { return c == '*' || c == '?'; }));
  const std::size_t own = pattern.size() - wildcards;
  if (own < 2 || pattern.size() > kLongest) return "";
  std::size_t best = std::max<std::size_t>(1, own / 3) + 1;
  std::string found;
  for (const std::string& text : texts) {
    if (text.size() > kLongest) continue;
    const std::size_t edits = edits_to_match(pattern, text);
    if (edits >= best) continue;
    best = edits;
    found = text;
  }
  return found;
}

}  // namespace robcogen
