#include "algorithm/catalogue/find.h"

#include <optional>

#include "support/concat.h"

namespace robcogen::algorithm {
namespace {

// The frames in a name, if it matches the pattern `jacobians.{A}_J_{B}`. A function of one frame is seen from the base.
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
  return scope.empty() ? name : replaced(scope, "::", ".") + "." + name;
}

namespace {

std::vector<Declared> found(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::vector<model::InverseTarget>& inverses,
    const std::string& name) {
  for (const Declaration& declaration : declarations()) {
    const auto frames = frames_in(tree, dotted(declaration.scope, declaration.name), name);
    if (!frames || !is_available(tree, declaration.group)) continue;
    const Subject subject = subject_of(tree, contacts, inverses, *frames);
    if (is_of(declaration, subject)) return overloads(declaration, subject);
  }
  return {};
}

}  // namespace

std::vector<Declared> find_function(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name) {
  return found(tree, contacts, {}, name);
}

std::vector<Declared> find_function(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& name) {
  return found(tree, desired.contacts, desired.inverses, name);
}

}  // namespace robcogen::algorithm
