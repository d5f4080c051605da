#include "driver/parameter_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace robcogen::driver {
namespace {

using model::Parameter;
using model::ParameterKind;

constexpr std::size_t kColumns = 110;

// The kind of a parameter, as the list says it.
std::string kind_of(const Parameter& p) {
  const std::string name = p.kind == ParameterKind::length  ? "lengths"
                           : p.kind == ParameterKind::angle ? "angles"
                           : p.kind == ParameterKind::ratio ? "ratios"
                                                            : "mass and drive properties";
  return p.is_in_masses_too ? name + ", in mass properties too" : name;
}

// `upper[0.35] 12:30`
std::string item(const Parameter& p) {
  std::string text = p.name;
  if (p.default_value) text += fmt::format("[{}]", print_double(*p.default_value));
  if (!p.place.source) return text;
  const Place place = written_at(p.place);
  const LineColumn at = place.source->locate(place.span.begin);
  return text + fmt::format(" {}:{}", at.line, at.column);
}

}  // namespace

void list_parameters(const std::vector<Parameter>& parameters, Diagnostics& diagnostics) {
  if (parameters.empty()) return;
  std::vector<std::pair<std::string, std::vector<std::string>>> kinds;
  for (const Parameter& p : parameters) {
    const std::string kind = kind_of(p);
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == kind; });
    auto& items = found == kinds.end() ? kinds.emplace_back(kind, std::vector<std::string>()).second : found->second;
    items.push_back(item(p));
  }
  Diagnostic& note = diagnostics.note(
      "parameters", parameters.front().place,
      parameters.size() == 1 ? "1 parameter: name[default] line:column"
                             : fmt::format("{} parameters: name[default] line:column", parameters.size()));
  for (const auto& [kind, items] : kinds) {
    std::string line = kind + ":";
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::string text = items[i] + (i + 1 < items.size() ? "," : "");
      if (line.size() + 1 + text.size() > kColumns) {
        note.details.push_back(line);
        line = " ";
      }
      line += " " + text;
    }
    note.details.push_back(line);
  }
}

}  // namespace robcogen::driver
