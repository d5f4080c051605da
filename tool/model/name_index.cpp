#include "model/name_index.h"

#include <fmt/format.h>

namespace robcogen::model {

namespace {

// Of ASCII letters, whatever the locale.
std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace

void NameIndex::add(const std::string& name, const Place& place, Diagnostics& diagnostics) {
  const int index = static_cast<int>(names_.size());
  names_.push_back(name);
  places_.push_back(place);
  const auto [same, is_new] = first_.insert({name, index});
  if (!is_new) {
    Diagnostic& error =
        diagnostics.error("duplicate-" + kind_, place, fmt::format("{} '{}' is declared twice", kind_, name));
    error.notes.push_back({place_of(same->second), "first declared here"});
    return;
  }
  const auto [similar, is_distinct] = first_in_lower_case_.insert({lower_case(name), index});
  if (!is_distinct) {
    const std::string& other = names_[static_cast<std::size_t>(similar->second)];
    Diagnostic& warning = diagnostics.warning(
        "names-differ-in-case", place, fmt::format("{}s '{}' and '{}' differ in case only", kind_, other, name));
    warning.notes.push_back({place_of(similar->second), fmt::format("'{}' is declared here", other)});
  }
}

std::optional<int> NameIndex::find(const std::string& name) const {
  const auto found = first_.find(name);
  if (found == first_.end()) return std::nullopt;
  return found->second;
}

bool NameIndex::is_repetition(int index) const {
  return find(names_[static_cast<std::size_t>(index)]) != index;
}

std::optional<int> NameIndex::nearest_to(const std::string& name) {
  if (questions_left_ == 0) return std::nullopt;
  --questions_left_;
  return find(nearest(name, names_));
}

}  // namespace robcogen::model
