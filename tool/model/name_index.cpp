#include "model/name_index.h"

#include "support/diagnostics.h"

namespace robcogen::model {

namespace {

// Converts ASCII letters only, independently of the locale.
std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

std::optional<int> find_in(const std::map<std::string, int>& map, const std::string& name) {
  const auto found = map.find(name);
  if (found == map.end()) return std::nullopt;
  return found->second;
}

}  // namespace

void NameIndex::add(const std::string& name) {
  const int index = static_cast<int>(names_.size());
  names_.push_back(name);
  first_.insert({name, index});
  first_in_lower_case_.insert({lower_case(name), index});
}

std::optional<int> NameIndex::find(const std::string& name) const {
  return find_in(first_, name);
}

std::optional<int> NameIndex::find_in_other_case(const std::string& name) const {
  const auto found = find_in(first_in_lower_case_, lower_case(name));
  if (!found || name_of(*found) == name) return std::nullopt;
  return found;
}

std::optional<int> NameIndex::nearest_to(const std::string& name) {
  if (questions_left_ == 0) return std::nullopt;
  --questions_left_;
  const std::string found = nearest(name, names_);
  return found.empty() ? std::nullopt : find(found);
}

}  // namespace robcogen::model
