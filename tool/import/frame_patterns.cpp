#include "import/frame_patterns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "support/wildcards.h"

namespace robcogen::import {
namespace {

using model::Frame;
using model::FramePair;
using model::KinematicTree;

// `fr_`
std::string implicit_prefix() {
  return model::implicit_frame_name("");
}

// `fr_foot` and `foot`, for frames of links and joints.
bool is_named(const std::string& pattern, const Frame& frame) {
  if (matches(pattern, frame.name)) return true;
  return frame.kind != Frame::Kind::user && matches(pattern, frame.name.substr(implicit_prefix().size()));
}

// Reports a pattern that names none of these frames.
void report_unmatched(
    const FramePattern& pattern,
    const std::string& where,
    const std::vector<Frame>& frames,
    Diagnostics& diagnostics) {
  constexpr std::size_t kShown = 12;
  std::vector<std::string> names;
  for (const Frame& frame : frames) names.push_back(frame.name);
  const bool is_name = !has_wildcards(pattern.text);
  std::string hint;
  if (is_name) {
    std::vector<std::string> short_names = names;  // with and without `fr_`
    for (const Frame& frame : frames)
      if (frame.kind != Frame::Kind::user) short_names.push_back(frame.name.substr(implicit_prefix().size()));
    hint = did_you_mean(pattern.text, short_names);
  } else if (const std::string similar = nearest_to_pattern(pattern.text, names); !similar.empty()) {
    hint = fmt::format("should it match '{}'?", similar);
  }
  if (!hint.empty()) hint += ' ';
  if (names.size() > kShown) {
    names.resize(kShown);
    names.emplace_back("…");
  }
  Diagnostic& error = diagnostics.error(
      "unmatched-frame", pattern.place,
      is_name ? fmt::format("{} has no frame '{}'", where, pattern.text)
              : fmt::format("no frame of {} matches '{}'", where, pattern.text));
  error.hint = hint + (names.empty() ? "it has none" : fmt::format("its frames are {}", fmt::join(names, ", ")));
}

// The names of the frames among these that the patterns name.
std::set<std::string> named_among(
    const std::vector<Frame>& frames,
    const std::vector<FramePattern>& patterns,
    const std::string& where,
    Diagnostics& diagnostics) {
  std::set<std::string> names;
  for (const FramePattern& pattern : patterns) {
    bool is_matched = false;
    for (const Frame& frame : frames) {
      if (!is_named(pattern.text, frame)) continue;
      names.insert(frame.name);
      is_matched = true;
    }
    if (!is_matched) report_unmatched(pattern, where, frames, diagnostics);
  }
  return names;
}

// The frame of exactly this name.
std::optional<Frame> frame_of_name(const KinematicTree& tree, const std::string& name) {
  const std::optional<Frame> frame = tree.find_frame(name);
  return frame ? frame : tree.find_frame(model::implicit_frame_name(name));
}

// The frames of a list, each once.
std::vector<Frame> frames_of(const model::DesiredTransforms& list) {
  std::vector<Frame> frames;
  std::set<std::string> seen;
  for (const std::vector<FramePair>* pairs : {&list.transforms, &list.jacobians})
    for (const FramePair& pair : *pairs)
      for (const Frame& frame : {pair.left, pair.right})
        if (seen.insert(frame.name).second) frames.push_back(frame);
  return frames;
}

}  // namespace

model::DesiredTransforms desired_by_patterns(
    const std::vector<FramePattern>& patterns,
    const KinematicTree& tree,
    Diagnostics& diagnostics) {
  std::vector<FramePattern> others;
  std::set<std::string> names;
  for (const FramePattern& pattern : patterns) {
    const std::optional<Frame> frame = has_wildcards(pattern.text) ? std::nullopt : frame_of_name(tree, pattern.text);
    if (frame)
      names.insert(frame->name);
    else
      others.push_back(pattern);
  }
  names.merge(named_among(model::link_and_user_frames(tree), others, fmt::format("robot '{}'", tree.name), diagnostics));
  std::vector<Frame> frames;
  for (const Frame& frame : tree.frames())
    if (names.contains(frame.name)) frames.push_back(frame);
  return model::desired_of_frames(tree, frames);
}

model::DesiredTransforms limited_by_patterns(
    const model::DesiredTransforms& list,
    const std::vector<FramePattern>& patterns,
    const KinematicTree& tree,
    Diagnostics& diagnostics) {
  const std::set<std::string> names =
      named_among(frames_of(list), patterns, "the list of desired transforms", diagnostics);
  const auto is_left_out = [&](const FramePair& pair) {
    const bool left = names.contains(pair.left.name), right = names.contains(pair.right.name);
    if (!left && !right) return true;
    return (!left && tree.link_of(pair.left) != 0) || (!right && tree.link_of(pair.right) != 0);
  };
  model::DesiredTransforms result = list;
  std::erase_if(result.transforms, is_left_out);
  std::erase_if(result.jacobians, is_left_out);
  return result;
}

}  // namespace robcogen::import
