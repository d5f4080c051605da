#include "import/desired_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/kinematic_tree.h"

namespace robcogen::import {

namespace desired = language::desired;

void FrameResolver::check() {
  check_owner();
  check_loops();
  check_list();
}

void FrameResolver::check_owner() {
  if (document_.robot.text == known_.owner) return;
  diagnostics_.warning(
      "robot-name-differs", place(document_.robot.span),
      fmt::format("this list is for {0} '{1}', but the {0} is '{2}'", known_.kind, document_.robot.text, known_.owner));
}

// A variable must not have the name of a link, frame or instance, which it would hide in the loop.
void FrameResolver::check_variable(const desired::Name& variable) {
  const auto is_in = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), variable.text) != names.end();
  };
  const bool is_link = is_in(known_.links), is_frame = known_.index.find(variable.text).has_value();
  if (!is_link && !is_frame && !is_in(known_.instances)) return;
  diagnostics_
      .error(
          "loop-variable", place(variable.span),
          fmt::format(
              "'{}' is already {} of {} '{}'", variable.text,
              is_link    ? "a link"
              : is_frame ? "a frame"
                         : "an instance",
              known_.kind, known_.owner))
      .hint = "choose another name for the loop variable";
}

void FrameResolver::check_loops() {
  for (const desired::Loop& loop : document_.loops) {
    check_variable(loop.variable);
    std::map<std::string, Span> listed;
    for (const desired::Name& instance : loop.instances) {
      const auto [earlier, is_new] = listed.insert({instance.text, instance.span});
      if (!is_new)
        diagnostics_
            .error(
                "repeated-instance", place(instance.span), fmt::format("instance '{}' is listed twice", instance.text))
            .notes.push_back({place(earlier->second), "first listed here"});
      else
        instances_.exists(instance.text, instance.span);
    }
  }
}

void FrameResolver::check_list() {
  std::map<std::string, Place> listed;
  for (desired::Name name : document_.frames) {
    if (!resolve(name)) continue;
    const auto [earlier, is_new] = listed.insert({name.text, place(name.span)});
    if (!is_new) {
      diagnostics_.warning("repeated-frame", place(name.span), fmt::format("frame '{}' is listed twice", name.text))
          .notes.push_back({earlier->second, "first listed here"});
    } else if (!known_.index.find(name.text)) {
      warn_unknown(name, "");
    }
    accepted_.insert(name.text);
  }
}

bool FrameResolver::resolve(desired::Name& name) {
  if (!name.instance.empty()) return instances_.resolve(name);
  if (name.loop != desired::Name::kNoLoop && !known_.index.find(name.text) &&
      known_.index.find(model::implicit_frame_name(name.text)))
    name.text = model::implicit_frame_name(name.text);
  return true;
}

std::optional<int> FrameResolver::frame(const desired::Name& name, const std::string& what) {
  const auto found = known_.index.find(name.text);
  if (!found) {
    warn_unknown(name, fmt::format(": this {} is left out", what));
  } else if (accepted_.insert(name.text).second) {
    diagnostics_.warning(
        "frame-not-listed", place(name.span), fmt::format("frame '{}' is not in the list of frames", name.text));
  }
  return found;
}

void FrameResolver::warn_unknown(const desired::Name& name, const std::string& consequence) {
  Diagnostic& warning = diagnostics_.warning(
      "unknown-frame", place(name.span),
      fmt::format("{} '{}' has no frame '{}'{}", known_.kind, known_.owner, name.text, consequence));
  const bool is_world = name.text == "world" || name.text == model::implicit_frame_name("world");
  if (is_world && known_.kind == "robot") {
    warning.hint = fmt::format(
        "the base is fixed to the world, or moves in it if 'floating': its frame is '{}'", known_.index.name_of(0));
  } else if (const auto similar = known_.index.nearest_to(name.text)) {
    warning.hint = fmt::format("did you mean '{}'?", known_.index.name_of(*similar));
  }
}

std::vector<ResolvedPair> FrameResolver::resolve(const std::vector<desired::Pair>& pairs, const std::string& what) {
  std::vector<ResolvedPair> resolved;
  std::map<std::pair<int, int>, Place> seen;
  for (desired::Pair pair : pairs) {
    const bool has_left = resolve(pair.left), has_right = resolve(pair.right);
    if (!has_left || !has_right) continue;
    const auto left = frame(pair.left, what);
    const auto right = frame(pair.right, what);
    if (!left || !right) continue;
    const auto [earlier, is_new] = seen.insert({{*left, *right}, place(pair.span)});
    if (is_new) {
      resolved.push_back({*left, *right, place(pair.span)});
    } else {
      diagnostics_
          .warning(
              "repeated-pair", place(pair.span),
              fmt::format("{} from '{}' to '{}' is listed twice", what, pair.right.text, pair.left.text))
          .notes.push_back({earlier->second, "first listed here"});
    }
  }
  return resolved;
}

}  // namespace robcogen::import
