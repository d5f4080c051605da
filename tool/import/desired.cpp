#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "import/desired_loops.h"
#include "import/frames.h"
#include "import/kinematics.h"
#include "model/name_index.h"

namespace robcogen::import {

namespace desired = language::desired;

namespace {

// The frames that a list may name: those of a robot, or of a model of motions.
struct Frames {
  std::string kind;  // "robot", "model"
  std::string owner;
  model::NameIndex index;
  std::vector<std::string> links = {};
  std::vector<std::string> instances = {};  // of parts
};

const std::string kFrame = "fr_";

// The names that `foot` of instance LF may have: LF_foot, fr_LF_foot.
std::vector<std::string> names_in_instance(const std::string& instance, const std::string& frame) {
  if (frame.starts_with(kFrame)) return {kFrame + instance + "_" + frame.substr(kFrame.size())};
  return {instance + "_" + frame, kFrame + instance + "_" + frame};
}

// A pair of the list, by index.
struct Resolved {
  int left;
  int right;
  Place place;
};

class FrameResolver {
 public:
  FrameResolver(const desired::Document& document, Frames& frames, Diagnostics& diagnostics)
      : document_(document), frames_(frames), diagnostics_(diagnostics) {}

  void check_name() {
    if (document_.robot.text == frames_.owner) return;
    diagnostics_.warning(
        "robot-name-differs", place(document_.robot.span),
        fmt::format(
            "this list is for {0} '{1}', but the {0} is '{2}'", frames_.kind, document_.robot.text, frames_.owner));
  }

  // Of every loop.
  void check_loops() {
    for (const desired::Loop& loop : document_.loops) {
      check_variable(loop.variable);
      std::map<std::string, Span> listed;
      for (const desired::Name& instance : loop.instances) {
        const auto [earlier, is_new] = listed.insert({instance.text, instance.span});
        if (!is_new)
          diagnostics_
              .error(
                  "repeated-instance", place(instance.span),
                  fmt::format("instance '{}' is listed twice", instance.text))
              .notes.push_back({place(earlier->second), "first listed here"});
        else
          is_instance(instance.text, instance.span);
      }
    }
  }

  void check_list() {
    std::map<std::string, Place> listed;
    for (desired::Name name : document_.frames) {
      if (!resolve(name)) continue;
      const auto [earlier, is_new] = listed.insert({name.text, place(name.span)});
      if (!is_new) {
        diagnostics_.warning("repeated-frame", place(name.span), fmt::format("frame '{}' is listed twice", name.text))
            .notes.push_back({earlier->second, "first listed here"});
      } else if (!frames_.index.find(name.text)) {
        warn_unknown(name, "");
      }
      accepted_.insert(name.text);
    }
  }

  // Pairs whose frames exist, each once. `what` is the meaning of a pair: `transform`, `Jacobian`.
  std::vector<Resolved> resolve(const std::vector<desired::Pair>& pairs, const std::string& what) {
    std::vector<Resolved> resolved;
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

  // Puts the name of the frame in place of `instance.frame`. False after reporting that there is none.
  bool resolve(desired::Name& name) {
    if (!name.instance.empty()) return resolve_in_instance(name);
    if (name.loop != desired::Name::kNoLoop && !frames_.index.find(name.text) && frames_.index.find(kFrame + name.text))
      name.text = kFrame + name.text;
    return true;
  }

 private:
  bool resolve_in_instance(desired::Name& name) {
    if (!is_instance(name.instance, name.instance_span)) return false;
    for (const std::string& candidate : names_in_instance(name.instance, name.text)) {
      if (!frames_.index.find(candidate)) continue;
      name.text = candidate;
      return true;
    }
    if (!reported_.insert({name.instance, name.text}).second) return false;
    Diagnostic& error = diagnostics_.error(
        "unknown-frame-of-instance", place(name.span),
        fmt::format("instance '{}' has no frame '{}'", name.instance, name.text));
    if (name.instance_span.begin < name.span.begin)
      error.notes.push_back({place(name.instance_span), fmt::format("'{}' is listed here", name.instance)});
    error.hint = did_you_mean(name.text, frames_of(name.instance));
    return false;
  }

  std::vector<std::string> all_frames() const {
    std::vector<std::string> names;
    for (int i = 0; i < frames_.index.size(); ++i) names.push_back(frames_.index.name_of(i));
    return names;
  }

  // As they are called in its part.
  std::vector<std::string> frames_of(const std::string& instance) const {
    std::vector<std::string> names;
    for (const std::string& name : all_frames())
      for (const std::string& prefix : {instance + "_", kFrame + instance + "_"})
        if (name.starts_with(prefix)) names.push_back(name.substr(prefix.size()));
    return names;
  }

  // An instance of a part, or a prefix of names that serves as one. Reports what is neither, once.
  bool is_instance(const std::string& instance, const Span& span) {
    if (instances_.contains(instance)) return true;
    const std::vector<std::string>& known = frames_.instances;
    if (std::find(known.begin(), known.end(), instance) != known.end() || !frames_of(instance).empty())
      return instances_.insert(instance).second;
    if (reported_.insert({instance, ""}).second)
      diagnostics_
          .error(
              "unknown-instance", place(span),
              fmt::format(
                  "{} '{}' has no instance '{}' of a part, nor frames whose names begin with '{}_'", frames_.kind,
                  frames_.owner, instance, instance))
          .hint = did_you_mean(instance, known);
    return false;
  }

  // It would hide the element in the loop.
  void check_variable(const desired::Name& variable) {
    const auto is_in = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), variable.text) != names.end();
    };
    const bool is_link = is_in(frames_.links), is_frame = frames_.index.find(variable.text).has_value();
    if (!is_link && !is_frame && !is_in(frames_.instances)) return;
    diagnostics_
        .error(
            "loop-variable", place(variable.span),
            fmt::format(
                "'{}' is {} of {} '{}' already", variable.text,
                is_link    ? "a link"
                : is_frame ? "a frame"
                           : "an instance",
                frames_.kind, frames_.owner))
        .hint = "choose another name for the variable of the loop";
  }

  Place place(const Span& span) const { return {document_.source, span}; }

  std::optional<int> frame(const desired::Name& name, const std::string& what) {
    const auto found = frames_.index.find(name.text);
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
        fmt::format("{} '{}' has no frame '{}'{}", frames_.kind, frames_.owner, name.text, consequence));
    const bool is_world = name.text == "world" || name.text == model::implicit_frame_name("world");
    if (is_world && frames_.kind == "robot") {
      warning.hint = fmt::format(
          "the base is fixed to the world, or moves in it when it is 'floating': its frame is '{}'",
          frames_.index.name_of(0));
    } else if (const auto similar = frames_.index.nearest_to(name.text)) {
      warning.hint = fmt::format("did you mean '{}'?", frames_.index.name_of(*similar));
    }
  }

  const desired::Document& document_;
  Frames& frames_;
  std::set<std::string> accepted_;                          // listed, or reported as not listed
  std::set<std::string> instances_;                         // that exist, of those that were asked for
  std::set<std::pair<std::string, std::string>> reported_;  // instances that do not exist, or lack a frame
  Diagnostics& diagnostics_;
};

// `'A' is connected to 'B', 'C'`, for a hint.
std::string connections(const model::RigidMotions& motions, const std::string& frame) {
  constexpr std::size_t kShown = 5;
  std::vector<std::string> names;
  for (const std::string& other : motions.frames) {
    if (other != frame && model::transform_between(motions, frame, other)) names.push_back(fmt::format("'{}'", other));
  }
  if (names.empty()) return fmt::format("'{}' is connected to no frame", frame);
  if (names.size() > kShown) {
    names.resize(kShown);
    names.push_back("…");
  }
  return fmt::format("'{}' is connected to {}", frame, fmt::join(names, ", "));
}

// With what there is, user frames first: of what moves.
void report_no_contact_frame(const NamedContact& contact, const model::KinematicTree& tree, Diagnostics& diagnostics) {
  constexpr std::size_t kShown = 12;
  model::NameIndex index;
  std::vector<std::string> names;
  for (const model::Frame& frame : tree.frames()) index.add(frame.name);
  for (const auto kind : {model::Frame::Kind::user, model::Frame::Kind::link})
    for (const model::Frame& frame : tree.frames())
      if (frame.kind == kind && (tree.floating_base || tree.link_of(frame) != 0)) names.push_back(frame.name);
  if (names.size() > kShown) {
    names.resize(kShown);
    names.emplace_back("…");
  }
  Diagnostic& error = diagnostics.error(
      "unknown-contact-frame", contact.place, fmt::format("robot '{}' has no frame '{}'", tree.name, contact.frame));
  const std::optional<int> similar = index.nearest_to(contact.frame);
  error.hint = (similar ? fmt::format("did you mean '{}'? ", index.name_of(*similar)) : std::string()) +
               fmt::format("its frames are {}", fmt::join(names, ", "));
}

}  // namespace

model::DesiredTransforms desired_transforms(
    const desired::Document& written,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics) {
  const desired::Document document = unrolled(written);
  const std::vector<model::Frame> all = tree.frames();
  Frames frames = {"robot", tree.name, {}};
  for (const model::Frame& frame : all) frames.index.add(frame.name);
  for (const model::Link& link : tree.links) frames.links.push_back(link.name);
  for (const model::Limb& limb : tree.limbs) frames.instances.push_back(limb.name);
  FrameResolver resolver(document, frames, diagnostics);
  resolver.check_name();
  resolver.check_loops();
  resolver.check_list();
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
  return result;
}

std::vector<model::ContactFrame> contact_frames(
    const std::vector<NamedContact>& names,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics) {
  const std::vector<model::Frame> all = tree.frames();
  std::map<std::string, Place> seen;
  std::vector<model::ContactFrame> contacts;
  for (const NamedContact& contact : names) {
    const std::optional<model::Frame> frame = tree.find_frame(contact.frame);
    const auto [earlier, is_new] = seen.insert({contact.frame, contact.place});
    if (!frame) {
      report_no_contact_frame(contact, tree, diagnostics);
    } else if (!is_new) {
      diagnostics
          .error("repeated-contact", contact.place, fmt::format("contact frame '{}' is listed twice", contact.frame))
          .notes.push_back({earlier->second, "first listed here"});
    } else if (!tree.floating_base && tree.link_of(*frame) == 0) {
      diagnostics
          .error(
              "contact-of-fixed-base", contact.place,
              fmt::format("contact frame '{}' does not move: it belongs to the fixed base", contact.frame))
          .hint = "list frames of links that move, or declare the base 'floating'";
    } else {
      contacts.push_back({*frame, contact.is_surface});
    }
  }
  return contacts;
}

std::vector<FrameNames> desired_frame_pairs(
    const desired::Document& written,
    const model::RigidMotions& motions,
    Diagnostics& diagnostics) {
  const desired::Document document = unrolled(written);
  Frames frames = {"model", motions.name, {}};
  for (const std::string& name : motions.frames) frames.index.add(name);
  FrameResolver resolver(document, frames, diagnostics);
  resolver.check_name();
  resolver.check_loops();
  resolver.check_list();
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
