#include "driver/find_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "backend/common/names.h"
#include "driver/failure.h"

namespace robcogen::driver {
namespace {

using algorithm::RobotFunction;

// The names of functions between two frames, `jacobians.` A `_J_` B, and of functions of one frame seen from the base,
// `world.J_` B.
struct NamePattern {
  std::string group;
  std::string prefix;
  std::string separator;  // empty: the function is of one frame

  std::string name(const model::FramePair& pair) const {
    return prefix + (separator.empty() ? "" : pair.left.name) + separator + pair.right.name;
  }
};

// The patterns of all functions between frames of the robot.
std::vector<NamePattern> patterns(const model::KinematicTree& tree, algorithm::FormulationChoices& formulations) {
  const std::vector<model::Frame> frames = tree.frames();
  // A moving link, if there is one.
  const auto last = std::find_if(
      frames.rbegin(), frames.rend(), [](const model::Frame& frame) { return frame.kind == model::Frame::Kind::link; });
  const model::FramePair pair = {frames.front(), *last};
  const model::DesiredTransforms desired = {{pair}, {pair}, {}};
  std::vector<NamePattern> found;
  for (const std::string& group : algorithm::groups_between_frames())
    for (const RobotFunction& f : algorithm::functions(tree, desired, group, formulations)) {
      if (f.frames.left.name.empty()) continue;  // a function of the whole robot
      const std::string before = f.name.substr(0, f.name.size() - pair.right.name.size());
      const bool is_of_two = before.size() > pair.left.name.size() && before.starts_with(pair.left.name);
      if (is_of_two)
        found.push_back({group, dotted(f.scope, ""), before.substr(pair.left.name.size())});
      else
        found.push_back({group, dotted(f.scope, before), ""});
    }
  return found;
}

// The frames in a name, if it matches the pattern.
std::optional<model::FramePair> frames_in(
    const model::KinematicTree& tree,
    const NamePattern& pattern,
    const std::string& name) {
  if (!name.starts_with(pattern.prefix)) return std::nullopt;
  const std::string rest = name.substr(pattern.prefix.size());
  if (pattern.separator.empty()) {
    const auto frame = tree.find_frame(rest);
    return frame ? std::optional(model::FramePair{tree.frames().front(), *frame}) : std::nullopt;
  }
  for (std::size_t at = rest.find(pattern.separator); at != std::string::npos;
       at = rest.find(pattern.separator, at + 1)) {
    const auto left = tree.find_frame(rest.substr(0, at));
    const auto right = tree.find_frame(rest.substr(at + pattern.separator.size()));
    if (left && right) return model::FramePair{*left, *right};
  }
  return std::nullopt;
}

// All groups. The first is the one with the name of the function. The last are those whose functions are between
// frames, because few of their functions are of the whole robot.
std::vector<std::string> groups_of_robot(const std::string& name) {
  const std::vector<std::string>& last = algorithm::groups_between_frames();
  std::vector<std::string> groups = algorithm::groups();
  std::stable_partition(groups.begin(), groups.end(), [&](const std::string& group) {
    return std::find(last.begin(), last.end(), group) == last.end();
  });
  std::stable_partition(groups.begin(), groups.end(), [&](const std::string& group) { return group == name; });
  return groups;
}

}  // namespace

std::string dotted(const std::string& scope, const std::string& name) {
  return backend::dotted(scope.empty() ? name : scope + "::" + name);
}

FoundFunctions find_functions(
    const Robot& robot,
    const std::string& name,
    algorithm::FormulationChoices& formulations) {
  FoundFunctions found;
  const auto search = [&](const std::string& group, const model::DesiredTransforms& desired) {
    for (RobotFunction& f : algorithm::functions(robot.tree, desired, group, formulations)) {
      found.names.push_back(dotted(f.scope, f.name));
      if (found.names.back() == name) found.overloads.push_back(std::move(f));
    }
    return !found.overloads.empty();
  };

  // No function of the whole robot has a name with two frames, and this test is the fastest.
  const std::vector<NamePattern> known = patterns(robot.tree, formulations);
  for (const NamePattern& pattern : known) {
    const std::optional<model::FramePair> pair = frames_in(robot.tree, pattern, name);
    if (pair && search(pattern.group, {{*pair}, {*pair}, {}})) return found;
  }
  for (const std::string& group : groups_of_robot(name))
    if (search(group, {{}, {}, robot.desired.contacts})) return found;
  for (const NamePattern& pattern : known)
    for (const auto* pairs : {&robot.desired.transforms, &robot.desired.jacobians})
      for (const model::FramePair& pair : *pairs) found.names.push_back(pattern.name(pair));
  return found;
}

void refuse_function(
    const std::string& owner,
    const std::filesystem::path& model,
    const std::string& name,
    const std::vector<std::string>& names) {
  const std::string guess = did_you_mean(name, names);
  throw Failure{
      wrong_usage, with_hint(
                       fmt::format("robcogen: error: {} has no function '{}' [unknown-function]", owner, name),
                       guess.empty() ? fmt::format("'robcogen ops {}' lists them", model.string()) : guess)};
}

}  // namespace robcogen::driver
