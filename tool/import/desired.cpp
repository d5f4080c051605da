#include <fmt/format.h>

#include <set>
#include <utility>

#include "import/kinematics.h"
#include "model/name_index.h"

namespace robcogen::import {

namespace desired = language::desired;

namespace {

class FrameResolver {
 public:
  FrameResolver(const desired::Document& document, const model::KinematicTree& tree, Diagnostics& diagnostics)
      : document_(document), robot_(tree.name), frames_(tree.frames()), diagnostics_(diagnostics) {
    for (const model::Frame& frame : frames_) index_.add(frame.name);
  }

  void check_list() {
    std::map<std::string, Place> listed;
    for (const desired::Name& name : document_.frames) {
      const auto [earlier, is_new] = listed.insert({name.text, place(name.span)});
      if (!is_new) {
        diagnostics_.warning("repeated-frame", place(name.span), fmt::format("frame '{}' is listed twice", name.text))
            .notes.push_back({earlier->second, "first listed here"});
      } else if (!index_.find(name.text)) {
        warn_unknown(name, "");
      }
      accepted_.insert(name.text);
    }
  }

  // Pairs whose frames exist, each once. `what` is what a pair stands for.
  std::vector<model::FramePair> resolve(const std::vector<desired::Pair>& pairs, const std::string& what) {
    std::vector<model::FramePair> resolved;
    std::map<std::pair<int, int>, Place> seen;
    for (const desired::Pair& pair : pairs) {
      const auto left = frame(pair.left, what);
      const auto right = frame(pair.right, what);
      if (!left || !right) continue;
      const auto [earlier, is_new] = seen.insert({{*left, *right}, place(pair.span)});
      if (is_new) {
        resolved.push_back({frames_[static_cast<std::size_t>(*left)], frames_[static_cast<std::size_t>(*right)]});
      } else {
        diagnostics_
            .warning(
                "repeated-pair", place(pair.span),
                fmt::format("{} from '{}' to '{}' is asked for twice", what, pair.right.text, pair.left.text))
            .notes.push_back({earlier->second, "first asked for here"});
      }
    }
    return resolved;
  }

 private:
  Place place(const Span& span) const { return {document_.source, span}; }

  std::optional<int> frame(const desired::Name& name, const std::string& what) {
    const auto found = index_.find(name.text);
    if (!found) {
      warn_unknown(name, fmt::format(": this {} is left out", what));
    } else if (accepted_.insert(name.text).second) {
      diagnostics_.warning(
          "frame-not-listed", place(name.span), fmt::format("frame '{}' is not in the list of frames", name.text));
    }
    return found;
  }

  void warn_unknown(const desired::Name& name, const std::string& consequence) {
    Diagnostic& warning = diagnostics_.warning(
        "unknown-frame", place(name.span),
        fmt::format("robot '{}' has no frame '{}'{}", robot_, name.text, consequence));
    if (const auto similar = index_.nearest_to(name.text)) {
      warning.hint = fmt::format("did you mean '{}'?", index_.name_of(*similar));
    }
  }

  const desired::Document& document_;
  const std::string& robot_;
  std::vector<model::Frame> frames_;
  model::NameIndex index_;
  std::set<std::string> accepted_;  // listed, or reported as not listed
  Diagnostics& diagnostics_;
};

}  // namespace

model::DesiredTransforms desired_transforms(
    const desired::Document& document,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics) {
  if (document.robot.text != tree.name) {
    diagnostics.warning(
        "robot-name-differs", {document.source, document.robot.span},
        fmt::format("this is a list for robot '{}', but the robot is '{}'", document.robot.text, tree.name));
  }
  FrameResolver resolver(document, tree, diagnostics);
  resolver.check_list();
  model::DesiredTransforms result;
  result.transforms = resolver.resolve(document.transforms, "transform");
  result.jacobians = resolver.resolve(document.jacobians, "Jacobian");
  return result;
}

const std::vector<std::string>& lenient_codes() {
  static const std::vector<std::string> codes = {
      "robot-name-differs", "unknown-frame", "frame-not-listed", "repeated-frame", "repeated-pair"};
  return codes;
}

}  // namespace robcogen::import
