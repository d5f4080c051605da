// Inlay hints: degrees after angles in radians, and the mass that a link carries after its `children {`.
#include <fmt/format.h>

#include <cmath>

#include "server/features.h"
#include "server/lookup.h"
#include "server/mechanics.h"
#include "server/values.h"

namespace robcogen::server {
namespace {

// Returns the offset after the brace of `children`, by the name of the link.
std::map<std::string, std::size_t> children_of_links(const Parsed& document) {
  std::map<std::string, std::size_t> places;
  const auto& tokens = document.tokens.tokens;
  std::string link;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].text == "Part") link = "";
    const bool begins_link = tokens[i].text == "link" || tokens[i].text == "RobotBase";
    if (begins_link && !tokens[i].escaped) link = tokens[i + 1].text;
    if (tokens[i].text == "children" && tokens[i + 1].text == "{" && !link.empty())
      places.insert({link, tokens[i + 1].span.end});
  }
  return places;
}

}  // namespace

Json inlay_hints(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  Json result = Json::array();
  if (lookup.document == nullptr) return result;
  const Positions& here = lookup.here();
  const Span range = here.span(parameters.at("range"));
  const auto add = [&](std::size_t offset, const std::string& label) {
    if (offset >= range.begin && offset <= range.end)
      result.push_back({{"position", here.json(offset)}, {"label", label}, {"paddingLeft", true}});
  };
  for (const Value& value : values_in(*lookup.document))
    if (value.is_angle && !value.number.is_zero()) add(value.span.end, degrees_of(value.number) + "°");
  if (lookup.document->robot() == nullptr) return result;
  if (const std::optional<model::KinematicTree> tree = tree_of(workspace, lookup.document->path)) {
    const RestingRobot resting(*tree);
    for (const auto& [name, offset] : children_of_links(*lookup.document)) {
      const std::optional<int> link = tree->find_link(name);
      const double carried = link ? resting.carried(*link).mass - resting.mass(*link) : 0.0;
      if (std::isfinite(carried) && carried > 0.0) add(offset, fmt::format("carries {:.4g} kg", carried));
    }
  }
  return result;
}

}  // namespace robcogen::server
