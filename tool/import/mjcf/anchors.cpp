#include "import/mjcf/anchors.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "support/index.h"

namespace robcogen::import::from_mjcf {

namespace {

void report_undeclared(
    const char* kind,
    const Name& name,
    const std::vector<std::string>& names,
    Diagnostics& diagnostics) {
  diagnostics.error("undeclared-end", name.place, fmt::format("{} '{}' is not declared", kind, name.text)).hint =
      did_you_mean(name.text, names);
}

const std::string& suffix_of(const Document& document, const Anchor& anchor) {
  const Body& body = document.bodies[anchor.body];
  return anchor.site < 0 ? body.written.suffix : body.sites[at(anchor.site)].written.suffix;
}

bool is_mocap(const Document& document, std::size_t body) {
  for (; body != 0; body = at(document.bodies[body].parent))
    if (document.bodies[body].is_mocap) return true;
  return false;
}

}  // namespace

std::vector<Anchor> anchors_at_bodies(const Document& document, const Name& name, Diagnostics& diagnostics) {
  if (name.text.empty() || name.text == "world") return {{0, {}, -1, name.place}};
  std::vector<Anchor> found;
  std::vector<std::string> names = {"world"};
  for (std::size_t b = 1; b < document.bodies.size(); ++b) {
    const Body& body = document.bodies[b];
    if (is_named(body, name.text)) found.push_back({b, {}, -1, name.place});
    if (!body.name.text.empty()) names.push_back(body.name.text);
  }
  if (found.empty()) report_undeclared("body", name, names, diagnostics);
  return found;
}

std::vector<Anchor> anchors_at_sites(const Document& document, const Name& name, Diagnostics& diagnostics) {
  std::vector<Anchor> found;
  std::vector<std::string> names;
  for (std::size_t b = 0; b < document.bodies.size(); ++b) {
    const std::vector<Site>& sites = document.bodies[b].sites;
    for (std::size_t s = 0; s < sites.size(); ++s) {
      if (is_named(sites[s], name.text)) found.push_back({b, sites[s].pose, static_cast<int>(s), name.place});
      if (!sites[s].name.text.empty()) names.push_back(sites[s].name.text);
    }
  }
  if (found.empty()) report_undeclared("site", name, names, diagnostics);
  return found;
}

std::vector<std::array<Anchor, 2>> paired(
    const Document& document,
    const std::vector<Anchor>& first,
    const std::vector<Anchor>& second) {
  std::vector<std::array<Anchor, 2>> pairs;
  // The longer list determines the number of pairs, so that each copy meets what is there once.
  const bool is_swapped = second.size() > first.size();
  const std::vector<Anchor>&all = is_swapped ? second : first, &others = is_swapped ? first : second;
  for (const Anchor& anchor : all) {
    if (others.empty()) break;
    const auto same = std::find_if(others.begin(), others.end(), [&](const Anchor& other) {
      return suffix_of(document, other) == suffix_of(document, anchor);
    });
    const Anchor& other = same == others.end() ? others.front() : *same;
    pairs.push_back(is_swapped ? std::array{other, anchor} : std::array{anchor, other});
  }
  return pairs;
}

std::size_t common_ancestor(const Document& document, std::size_t first, std::size_t second) {
  // Parents stand before their children.
  while (first != second) {
    std::size_t& later = first > second ? first : second;
    later = at(document.bodies[later].parent);
  }
  return first;
}

std::vector<std::size_t> path(const Document& document, std::size_t body, std::size_t ancestor) {
  std::vector<std::size_t> bodies;
  for (; body != ancestor; body = at(document.bodies[body].parent)) bodies.push_back(body);
  return bodies;
}

Pose drawn_pose(const Document& document, std::size_t first, std::size_t second) {
  const std::size_t ancestor = common_ancestor(document, first, second);
  const auto in_ancestor = [&](std::size_t body) {
    Pose pose;
    for (const std::size_t b : path(document, body, ancestor)) pose = document.bodies[b].pose * pose;
    return pose;
  };
  return inverse(in_ancestor(first)) * in_ancestor(second);
}

std::string fault_of(const Document& document, const std::array<Anchor, 2>& ends, bool& is_outside) {
  const auto has = [&](const Anchor& end) { return document.robot.has[end.body]; };
  const auto name = [&](const Anchor& end) { return label_of(document, end.body); };
  is_outside = !has(ends[0]) && !has(ends[1]);
  for (const Anchor& end : ends) {
    if (is_mocap(document, end.body)) return fmt::format("'{}' is a motion-capture body", name(end));
    if (!has(end)) return fmt::format("'{}' is not part of the robot", name(end));
  }
  const std::size_t ancestor = common_ancestor(document, ends[0].body, ends[1].body);
  for (const Anchor& end : ends)
    for (const std::size_t b : path(document, end.body, ancestor))
      if (!document.bodies[b].joints.empty()) return "";
  return fmt::format("no joint is between '{}' and '{}'", name(ends[0]), name(ends[1]));
}

}  // namespace robcogen::import::from_mjcf
