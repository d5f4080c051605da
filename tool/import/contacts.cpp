// Finds contact frames by name.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "import/kinematics.h"
#include "model/name_index.h"

namespace robcogen::import {
namespace {

// Reports an unknown frame, and lists the frames that move, user frames first.
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

}  // namespace robcogen::import
