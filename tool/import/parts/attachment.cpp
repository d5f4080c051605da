#include "import/parts/attachment.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "import/parts/placements.h"
#include "import/parts/terms.h"

namespace robcogen::import::parts {
namespace {

using kinematics::Body;
using kinematics::Child;
using kinematics::Instance;
using kinematics::Joint;
using kinematics::Link;

// Keeps the base as a link on a joint that does not move.
void keep_base(Assembly& part, const Placement& at, std::vector<Child>& children) {
  Link base = std::move(*part.base);
  base.is_base = base.floating = false;
  base.children = std::move(part.roots);
  Joint mount;
  mount.name = {base.name.text + "_mount", base.name.span};
  mount.placement = at;
  children.push_back({base.name, mount.name});
  part.body.couplings.push_back({mount.name, term(Number(), base.name.span)});
  part.body.links.insert(part.body.links.begin(), std::move(base));
  part.body.joints.insert(part.body.joints.begin(), std::move(mount));
}

class Attachment {
 public:
  Attachment(const Instance& instance, const std::shared_ptr<const Source>& source, Diagnostics& diagnostics)
      : instance_(instance),
        at_(instance.placement.value_or(identity(instance.name.span))),
        source_(source),
        diagnostics_(diagnostics) {}

  Body run(Assembly part, Link& link, std::vector<Child>& children) {
    const bool keeps_base = instance_.keep && part.base;
    if (instance_.keep && !part.base)
      diagnostics_.error(
          "no-base-to-keep", {source_, *instance_.keep},
          fmt::format("part '{}' has no base: only a robot has one", instance_.part.text));
    if (keeps_base) {
      keep_base(part, at_, children);
    } else {
      for (const Child& root : part.roots) carry(part.body, root);
      children.insert(children.end(), part.roots.begin(), part.roots.end());
      if (part.base) lump(*part.base, link, part.body);
    }
    return std::move(part.body);
  }

 private:
  const Instance& instance_;
  const Placement at_;
  const std::shared_ptr<const Source>& source_;
  Diagnostics& diagnostics_;

  // Places a joint of the base on the link instead. The axis of its rotor is converted to the axes of the link too.
  void carry(Body& body, const Child& root) {
    for (Joint& joint : body.joints) {
      if (joint.name.text != root.joint.text) continue;
      place_at(joint.placement, fmt::format("joint '{}'", joint.name.text));
      const auto words = kinematics::coordinate_words(joint.type);
      std::optional<kinematics::Rotor>* rotor = &joint.rotor;  // the rotor that the link carries
      for (kinematics::Coordinate& coordinate : joint.coordinates)
        if (coordinate.word.text == words.front()) rotor = &coordinate.rotor;
      if (*rotor && (*rotor)->axis && !(*rotor)->carrier)
        (*rotor)->axis = product(rotation_matrix(at_.rotation), *(*rotor)->axis);
    }
  }

  void place_at(Placement& placement, const std::string& what) {
    if (const std::optional<Placement> joined = composed(at_, placement)) {
      placement = *joined;
      return;
    }
    diagnostics_
        .error(
            "rotation-with-parameter", {source_, at_.span},
            fmt::format(
                "the rotations of '{}' and of {} depend on parameters: they cannot be combined into one",
                instance_.name.text, what))
        .hint = "give one of them a constant rotation, or none";
  }

  // Makes the base part of the link. Its frames, including the frame of the base itself, become frames of the link.
  void lump(Link& base, Link& link, Body& body) {
    link.inertia = lumped(link, base, at_);
    link.frames.push_back({{"fr_" + base.name.text, base.name.span}, at_});
    for (kinematics::Frame& frame : base.frames) {
      place_at(frame.placement, fmt::format("frame '{}'", frame.name.text));
      link.frames.push_back(std::move(frame));
    }
    for (Joint& joint : body.joints) {
      for (kinematics::Rotor* rotor : rotors_of(joint)) {
        if (!rotor->carrier || rotor->carrier->text != base.name.text) continue;
        rotor->carrier->text = link.name.text;
        if (rotor->axis) rotor->axis = product(rotation_matrix(at_.rotation), *rotor->axis);
      }
    }
  }
};

}  // namespace

Body join_to_link(
    Assembly part,
    const Instance& instance,
    Link& link,
    std::vector<Child>& children,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics) {
  return Attachment(instance, source, diagnostics).run(std::move(part), link, children);
}

}  // namespace robcogen::import::parts
