#include "import/xml/namer.h"

#include <fmt/format.h>

#include "import/identifier.h"

namespace robcogen::import::xml {

namespace {

constexpr std::size_t kMaxNameLength = 255;  // of a robot document

}  // namespace

void Namer::check_length(const char* kind, const Name& name) {
  if (name.text.size() <= kMaxNameLength) return;
  diagnostics_.error(
      "name-too-long", name.place,
      fmt::format("the name of this {} has more than {} characters", kind, kMaxNameLength));
}

std::string Namer::element(
    const char* kind,
    const Name& name,
    const std::string& wanted,
    const std::string& suffix,
    UniqueNames& taken) {
  check_length(kind, name);
  if (!name.text.empty()) {
    const auto [earlier, is_new] = declared_.insert({kind + (":" + name.text), name.place});
    if (!is_new) {
      diagnostics_.error("duplicate-name", name.place, fmt::format("{} '{}' is declared twice", kind, name.text))
          .notes.push_back({earlier->second, "first declared here"});
      return "";
    }
  }
  std::string identifier = import::identifier(wanted);
  if (taken.contains(identifier)) identifier += suffix;
  identifier = taken.add(identifier);
  if (identifier == name.text) return identifier;
  if (changes_.empty()) first_change_ = name.place;
  changes_.push_back(
      name.text.empty() ? fmt::format("a {} without a name becomes '{}'", kind, identifier)
                        : fmt::format("{} '{}' becomes '{}'", kind, name.text, identifier));
  return identifier;
}

void Namer::mention_changes() {
  constexpr std::size_t kShown = 4;
  if (changes_.empty()) return;
  std::string list;
  for (std::size_t i = 0; i < changes_.size() && i < kShown; ++i) list += (i == 0 ? "" : ", ") + changes_[i];
  if (changes_.size() > kShown) list += fmt::format(", and {} more", changes_.size() - kShown);
  diagnostics_.note("names-changed", first_change_, list);
}

}  // namespace robcogen::import::xml
