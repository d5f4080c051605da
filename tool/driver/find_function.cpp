#include "driver/find_function.h"

#include <fmt/format.h>

#include <optional>

#include "backend/common/names.h"
#include "driver/failure.h"

namespace robcogen::driver {
namespace {

using algorithm::Declaration;
using algorithm::Declared;
using algorithm::Subject;

// The pattern of the name: `jacobians.{A}_J_{B}`.
std::string pattern_of(const Declaration& declaration) {
  return dotted(declaration.scope, declaration.name);
}

// The frames in a name, if it matches the pattern. A function of one frame is seen from the base.
std::optional<model::FramePair> frames_in(
    const model::KinematicTree& tree,
    const std::string& pattern,
    const std::string& name) {
  const std::size_t first = pattern.find('{');
  if (first == std::string::npos) return name == pattern ? std::optional(model::FramePair()) : std::nullopt;
  if (name.compare(0, first, pattern, 0, first) != 0) return std::nullopt;
  const std::string rest = name.substr(first);
  const std::size_t second = pattern.find('{', first + 1);
  if (second == std::string::npos) {
    const auto frame = tree.find_frame(rest);
    return frame ? std::optional(model::FramePair{tree.frames().front(), *frame}) : std::nullopt;
  }
  const std::size_t between = pattern.find('}') + 1;
  const std::string separator = pattern.substr(between, second - between);
  for (std::size_t at = rest.find(separator); at != std::string::npos; at = rest.find(separator, at + 1)) {
    const auto left = tree.find_frame(rest.substr(0, at));
    const auto right = tree.find_frame(rest.substr(at + separator.size()));
    if (left && right) return model::FramePair{*left, *right};
  }
  return std::nullopt;
}

}  // namespace

std::string dotted(const std::string& scope, const std::string& name) {
  return backend::dotted(scope.empty() ? name : scope + "::" + name);
}

std::vector<Declared> find_functions(const Robot& robot, const std::string& name) {
  for (const Declaration& declaration : algorithm::declarations()) {
    const std::optional<model::FramePair> frames = frames_in(robot.tree, pattern_of(declaration), name);
    if (!frames || !algorithm::is_available(robot.tree, declaration.group)) continue;
    const Subject subject{robot.tree, robot.desired.contacts, *frames};
    if (algorithm::is_of(declaration, subject)) return algorithm::overloads(declaration, subject);
  }
  return {};
}

std::vector<std::string> function_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const std::string& group : algorithm::groups())
    for (const Declared& f : algorithm::declared(robot.tree, robot.desired, group))
      names.push_back(dotted(f.is->scope, f.name));
  return names;
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
