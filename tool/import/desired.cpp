// Resolves lists of desired transforms to frames of a robot or of rigid motions.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "import/desired_frames.h"
#include "import/desired_loops.h"
#include "import/frames.h"
#include "import/kinematics.h"

namespace robcogen::import {

namespace desired = language::desired;

namespace {

// Returns text for a hint, as in `'A' is connected to 'B', 'C'`.
std::string connections(const model::RigidMotions& motions, const std::string& frame) {
  constexpr std::size_t kShown = 5;
  std::vector<std::string> names;
  for (const std::string& other : motions.frames) {
    if (other != frame && model::transform_between(motions, frame, other)) names.push_back(fmt::format("'{}'", other));
  }
  if (names.empty()) return fmt::format("'{}' is not connected to any frame", frame);
  if (names.size() > kShown) {
    names.resize(kShown);
    names.push_back("…");
  }
  return fmt::format("'{}' is connected to {}", frame, fmt::join(names, ", "));
}

}  // namespace

model::DesiredTransforms desired_transforms(
    const desired::Document& written,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics) {
  const desired::Document document = unrolled(written);
  const std::vector<model::Frame> all = tree.frames();
  KnownFrames frames = {"robot", tree.name, {}};
  for (const model::Frame& frame : all) frames.index.add(frame.name);
  for (const model::Link& link : tree.links) frames.links.push_back(link.name);
  for (const model::Limb& limb : tree.limbs) frames.instances.push_back(limb.name);
  FrameResolver resolver(document, frames, diagnostics);
  resolver.check();
  const auto resolve = [&](const std::vector<desired::Pair>& pairs, const std::string& what) {
    std::vector<model::FramePair> result;
    for (const auto& [left, right, place] : resolver.resolve(pairs, what))
      result.push_back({all[static_cast<std::size_t>(left)], all[static_cast<std::size_t>(right)]});
    return result;
  };
  model::DesiredTransforms result;
  result.transforms = resolve(document.transforms, "transform");
  result.jacobians = resolve(document.jacobians, "Jacobian");
  std::vector<NamedContact> contacts;
  for (desired::Contact contact : document.contacts)
    if (resolver.resolve(contact.frame))
      contacts.push_back({contact.frame.text, contact.is_surface, {document.source, contact.frame.span}});
  result.contacts = contact_frames(contacts, tree, diagnostics);
  std::vector<NamedInverse> inverses;
  for (const desired::Inverse& written_inverse : document.inverses) {
    desired::Inverse inverse = written_inverse;
    const bool has_left = resolver.resolve(inverse.pair.left), has_right = resolver.resolve(inverse.pair.right);
    if (!has_left || !has_right) continue;
    using model::InverseTask;
    const InverseTask::Kind kind = inverse.task == desired::Inverse::Task::point  ? InverseTask::Kind::point
                                   : inverse.task == desired::Inverse::Task::axis ? InverseTask::Kind::axis
                                                                                  : InverseTask::Kind::pose;
    inverses.push_back(
        {inverse.pair.left.text,
         inverse.pair.right.text,
         kind,
         inverse.task == desired::Inverse::Task::swivel,
         inverse.given.text,
         inverse.tolerance,
         {document.source, inverse.pair.span}});
  }
  result.inverses = inverse_targets(inverses, tree, diagnostics);
  result.functions = fused_functions(document.functions, document.source);
  return result;
}

std::vector<model::FusedFunction> fused_functions(
    const std::vector<desired::Function>& functions,
    const std::shared_ptr<const Source>& source) {
  std::vector<model::FusedFunction> result;
  for (const desired::Function& function : functions) {
    model::FusedFunction& fused = result.emplace_back();
    fused.name = function.name.text;
    fused.place = {source, function.name.span};
    for (const desired::Name& part : function.parts) fused.parts.push_back({part.text, {source, part.span}});
  }
  return result;
}

std::vector<FrameNames> desired_frame_pairs(
    const desired::Document& written,
    const model::RigidMotions& motions,
    Diagnostics& diagnostics) {
  const desired::Document document = unrolled(written);
  KnownFrames frames = {"model", motions.name, {}};
  for (const std::string& name : motions.frames) frames.index.add(name);
  FrameResolver resolver(document, frames, diagnostics);
  resolver.check();
  if (!document.jacobians.empty()) {
    diagnostics.error(
        "jacobian-without-robot", {document.source, document.jacobians.front().span},
        "Jacobians need a robot: motions have no joints");
  }
  if (!document.contacts.empty()) {
    diagnostics.error(
        "contact-without-robot", {document.source, document.contacts.front().frame.span},
        "contacts need a robot: motions have no dynamics");
  }
  if (!document.functions.empty()) {
    diagnostics.error(
        "function-without-robot", {document.source, document.functions.front().name.span},
        "fused functions need a robot: motions have transforms only");
  }
  if (!document.inverses.empty()) {
    diagnostics.error(
        "inverse-without-robot", {document.source, document.inverses.front().pair.span},
        "inverse kinematics needs a robot: motions have no joints");
  }
  std::vector<FrameNames> result;
  for (const auto& [left_index, right_index, place] : resolver.resolve(document.transforms, "transform")) {
    const std::string &left = frames.index.name_of(left_index), &right = frames.index.name_of(right_index);
    if (model::transform_between(motions, left, right)) {
      result.emplace_back(left, right);
      continue;
    }
    diagnostics.error("not-connected", place, fmt::format("no motions connect frame '{}' to frame '{}'", left, right))
        .hint = fmt::format("{}; {}", connections(motions, left), connections(motions, right));
  }
  return result;
}

const std::vector<std::string>& lenient_codes() {
  static const std::vector<std::string> codes = {
      "robot-name-differs", "unknown-frame", "frame-not-listed", "repeated-frame", "repeated-pair"};
  return codes;
}

}  // namespace robcogen::import
