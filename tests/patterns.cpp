#include "patterns.h"

#include <map>
#include <regex>

namespace robcogen::test {
namespace {

// The expressions are kept, because tests apply the same one to many lines.
const std::regex& compiled(const std::string& pattern) {
  static thread_local std::map<std::string, std::regex> all;
  const auto at = all.find(pattern);
  return at != all.end() ? at->second : all.emplace(pattern, pattern).first->second;
}

Match groups_of(const std::smatch& found) {
  return {found.begin(), found.end()};
}

}  // namespace

std::optional<Match> whole_match(const std::string& text, const std::string& pattern) {
  std::smatch found;
  if (!std::regex_match(text, found, compiled(pattern))) return std::nullopt;
  return groups_of(found);
}

std::optional<Match> first_match(const std::string& text, const std::string& pattern) {
  std::smatch found;
  if (!std::regex_search(text, found, compiled(pattern))) return std::nullopt;
  return groups_of(found);
}

std::vector<Match> all_matches(const std::string& text, const std::string& pattern) {
  std::vector<Match> result;
  for (std::sregex_iterator it(text.begin(), text.end(), compiled(pattern)), end; it != end; ++it)
    result.push_back(groups_of(*it));
  return result;
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, compiled(pattern), by);
}

}  // namespace robcogen::test
