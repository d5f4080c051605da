#include "import/urdf/link_pair.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/name_index.h"
#include "support/index.h"

namespace robcogen::import::from_urdf {
namespace {

std::optional<int> find_link(
    const Name& name,
    const std::string& owner,
    const Document& document,
    const std::vector<Carried>& carried,
    Diagnostics& diagnostics) {
  model::NameIndex names;
  for (const Link& link : document.links) names.add(link.name.text);
  const auto found = names.find(name.text);
  if (found && carried[at(*found)].body >= 0) return found;
  Diagnostic& error = diagnostics.error(
      "loop-without-link", name.place,
      found ? fmt::format("{} refers to link '{}', which is not part of the robot", owner, name.text)
            : fmt::format("{} refers to undeclared link '{}'", owner, name.text));
  if (const auto similar = found ? std::nullopt : names.nearest_to(name.text))
    error.hint = fmt::format("did you mean '{}'?", names.name_of(*similar));
  return std::nullopt;
}

// Joints from the root to the link.
std::vector<int> path_to(int link, const Topology& topology) {
  std::vector<int> joints;
  for (int j = topology.parent_joint[at(link)]; j >= 0; j = topology.parent_joint[at(topology.parent[at(j)])])
    joints.push_back(j);
  std::reverse(joints.begin(), joints.end());
  return joints;
}

std::array<std::vector<int>, 2> paths_to(
    const std::array<int, 2>& links,
    const Document& document,
    const Topology& topology) {
  std::array<std::vector<int>, 2> paths = {path_to(links[0], topology), path_to(links[1], topology)};
  const auto [first, second] = std::mismatch(paths[0].begin(), paths[0].end(), paths[1].begin(), paths[1].end());
  paths[0].erase(paths[0].begin(), first);
  paths[1].erase(paths[1].begin(), second);
  for (std::vector<int>& path : paths)
    std::erase_if(path, [&](int j) { return document.joints[at(j)].type == JointType::fixed; });
  return paths;
}

}  // namespace

std::optional<LinkPair> find_link_pair(
    const std::array<Name, 2>& names,
    const std::string& owner,
    const Document& document,
    const Topology& topology,
    const std::vector<Carried>& carried,
    Diagnostics& diagnostics) {
  const auto predecessor = find_link(names[0], owner, document, carried, diagnostics);
  const auto successor = find_link(names[1], owner, document, carried, diagnostics);
  if (!predecessor || !successor) return std::nullopt;
  const std::array<int, 2> links = {*predecessor, *successor};
  return LinkPair{links, paths_to(links, document, topology)};
}

}  // namespace robcogen::import::from_urdf
