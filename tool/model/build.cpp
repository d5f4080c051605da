// Builds the kinematic tree from a description, whose elements refer to one another by name.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "model/actuators.h"
#include "model/couplings.h"
#include "model/description.h"
#include "model/loops.h"
#include "model/name_index.h"
#include "model/plausibility.h"
#include "model/spherical_joints.h"
#include "model/tendons.h"
#include "support/index.h"

namespace robcogen::model {

namespace {

// The parent of a link, and where the document lists the link as its child.
struct Parenthood {
  int parent = -1;  // link
  Place place;
};

// The state that the steps of `build` share.
struct Assembly {
  const Description& description;
  Diagnostics& diagnostics;
  NameIndex links{};
  NameIndex joints{};
  NameIndex frames{};
  KinematicTree tree{};
  std::vector<std::optional<Parenthood>> parents{};  // by link
  std::vector<std::optional<Place>> joint_uses{};    // by joint
  // Elements that a misspelt name probably refers to. They are not also reported as unused.
  std::set<int> meant_links{};
  std::set<int> meant_joints{};
  // After an error about a name, errors that may follow from it are not reported.
  bool links_repeat = false;
  bool joints_repeat = false;

  std::size_t link_count() const { return description.links.size() + 1; }
  const DescribedLink& link(std::size_t index) const { return described_link(description, index); }
};

// Adds a name to `index`. Reports a name that another element has, or that differs from another name in case only.
// `elements` are the elements added so far. Returns whether the name is new.
template <class Element>
bool declare(
    NameIndex& index,
    const char* kind,
    const char* duplicate_code,
    const std::string& name,
    const Place& place,
    const std::vector<Element>& elements,
    Diagnostics& diagnostics) {
  const auto same = index.find(name);
  if (same) {
    diagnostics.error(duplicate_code, place, fmt::format("{} '{}' is declared twice", kind, name))
        .notes.push_back({elements[at(*same)].place, "first declared here"});
  } else if (const auto similar = index.find_in_other_case(name)) {
    const Element& other = elements[at(*similar)];
    diagnostics
        .warning(
            "names-differ-in-case", place, fmt::format("{}s '{}' and '{}' differ in case only", kind, other.name, name))
        .notes.push_back({other.place, fmt::format("'{}' is declared here", other.name)});
  }
  index.add(name);
  return !same;
}

void declare_elements(Assembly& a) {
  for (std::size_t i = 0; i < a.link_count(); ++i) {
    const DescribedLink& link = a.link(i);
    if (!declare(a.links, "link", "duplicate-link", link.name, link.place, a.tree.links, a.diagnostics))
      a.links_repeat = true;
    a.tree.links.push_back({link.name, link.inertia, -1, {}, link.place, link.is_virtual});
  }
  for (const DescribedJoint& joint : a.description.joints) {
    if (!declare(a.joints, "joint", "duplicate-joint", joint.name, joint.place, a.tree.joints, a.diagnostics))
      a.joints_repeat = true;
    a.tree.joints.push_back(
        {joint.name, joint.type, -1, -1, joint.placement, joint.place, joint.limits, joint.drive, joint.pitch,
         joint.assembled});
    a.tree.joints.back().motor_of = joint.motor_of;
    if (const auto link = a.links.find(joint.name)) {
      a.diagnostics
          .error(
              "frame-name-clash", joint.place,
              fmt::format(
                  "joint '{0}' and link '{0}' would both have the frame '{1}'", joint.name,
                  implicit_frame_name(joint.name)))
          .notes.push_back({a.tree.links[at(*link)].place, "the link is declared here"});
    }
  }
  a.parents.resize(a.tree.links.size());
  a.joint_uses.resize(a.tree.joints.size());
}

// The coordinates of a spherical joint and the elements of its quaternion have implicit names, which no other joint may
// have.
void check_names_of_components(Assembly& a) {
  for (const DescribedJoint& joint : a.description.joints) {
    if (joint.type != JointType::spherical) continue;
    for (const char* suffix : kQuaternionSuffixes) {
      const auto other = a.joints.find(joint.name + suffix);
      if (!other) continue;
      a.diagnostics
          .error(
              "component-name-clash", a.tree.joints[at(*other)].place,
              fmt::format(
                  "joint '{}{}' has the name of a coordinate of spherical joint '{}'", joint.name, suffix, joint.name))
          .notes.push_back({joint.place, "the spherical joint is declared here"});
    }
  }
}

// Returns the owner of the implicit frame of this name, as in "link 'hip'"; empty if there is no such frame.
std::string owner_of_implicit_frame(const Assembly& a, const std::string& frame) {
  const std::string prefix = implicit_frame_name("");
  if (!frame.starts_with(prefix)) return "";
  const std::string element = frame.substr(prefix.size());
  if (a.links.find(element)) return fmt::format("link '{}'", element);
  if (a.joints.find(element)) return fmt::format("joint '{}'", element);
  return "";
}

void declare_frames(Assembly& a) {
  for (std::size_t i = 0; i < a.link_count(); ++i) {
    for (const DescribedFrame& frame : a.link(i).frames) {
      declare(a.frames, "frame", "duplicate-frame", frame.name, frame.place, a.tree.user_frames, a.diagnostics);
      const std::string owner = owner_of_implicit_frame(a, frame.name);
      if (!owner.empty()) {
        a.diagnostics.warning(
            "frame-hidden", frame.place,
            fmt::format(
                "frame '{}' has the name of the implicit frame of {}: transforms and Jacobians use that frame, and "
                "this one serves only as a ref_frame",
                frame.name, owner));
      }
      a.tree.user_frames.push_back(
          {frame.name, static_cast<int>(i), frame.placement, !owner.empty(), frame.place, frame.by_name_only});
    }
  }
}

void place_shapes(Assembly& a) {
  for (std::size_t i = 0; i < a.link_count(); ++i) {
    for (Shape shape : a.link(i).shapes) {
      shape.link = static_cast<int>(i);
      a.tree.geometry.shapes.push_back(std::move(shape));
    }
  }
}

// Stores the pose of the reference frame in the mass properties.
void resolve_reference(Assembly& a, std::size_t index) {
  const DescribedLink& link = a.link(index);
  if (!link.inertia || !link.reference_frame) return;
  const std::string& name = *link.reference_frame;
  std::vector<std::string> own_names;
  for (const DescribedFrame& frame : link.frames) {
    if (frame.name == name) {
      a.tree.links[index].inertia->reference = frame.placement;
      return;
    }
    own_names.push_back(frame.name);
  }
  if (const auto elsewhere = a.frames.find(name)) {
    const UserFrame& frame = a.tree.user_frames[at(*elsewhere)];
    Diagnostic& error = a.diagnostics.error(
        "reference-frame-elsewhere", link.reference_place,
        fmt::format(
            "ref_frame '{}' of link '{}' is a frame of link '{}'", name, link.name, a.tree.links[at(frame.link)].name));
    error.notes.push_back({frame.place, "the frame is declared here"});
  } else {
    a.diagnostics
        .error(
            "unknown-reference-frame", link.reference_place,
            fmt::format("link '{}' has no frame '{}'", link.name, name))
        .hint = did_you_mean(name, own_names);
  }
}

std::optional<int> find_or_report(
    NameIndex& index,
    const char* kind,
    const char* unknown_code,
    const std::string& name,
    const Place& place,
    bool repeats,
    std::set<int>& meant,
    Diagnostics& diagnostics) {
  if (const auto found = index.find(name)) return found;
  if (repeats) return std::nullopt;  // the name may refer to one of the duplicates
  Diagnostic& error = diagnostics.error(unknown_code, place, fmt::format("{} '{}' is not declared", kind, name));
  if (name == "world") {
    error.hint = "omit the world: the RobotBase is fixed to the world, or moves in it if 'floating'";
  } else if (const auto similar = index.nearest_to(name)) {
    error.hint = fmt::format("did you mean '{}'?", index.name_of(*similar));
    meant.insert(*similar);
  }
  return std::nullopt;
}

// Whether `child` may become a child of `parent`; reports why not.
bool may_adopt(Assembly& a, int parent, int child, const Place& place) {
  const std::string& name = a.tree.links[at(child)].name;
  const std::string& parent_name = a.tree.links[at(parent)].name;
  if (a.links_repeat && (name == parent_name || a.parents[at(child)])) return false;
  if (child == parent) {
    a.diagnostics.error("self-loop", place, fmt::format("link '{}' is a child of itself", name));
    return false;
  }
  if (child == 0) {
    a.diagnostics.error(
        "base-as-child", place, fmt::format("the base '{}' is listed as a child of link '{}'", name, parent_name));
    return false;
  }
  const auto& earlier = a.parents[at(child)];
  if (!earlier) return true;
  const bool same_parent = earlier->parent == parent;
  const std::string message =
      same_parent
          ? fmt::format("link '{}' is listed twice as a child of '{}'", name, parent_name)
          : fmt::format(
                "link '{}' has two parents, '{}' and '{}'", name, a.tree.links[at(earlier->parent)].name, parent_name);
  Diagnostic& error = a.diagnostics.error(same_parent ? "link-used-twice" : "two-parents", place, message);
  error.notes.push_back({earlier->place, "first listed here"});
  return false;
}

void link_child(Assembly& a, int parent, const DescribedChild& child) {
  const auto link = find_or_report(
      a.links, "link", "unknown-link", child.link, child.link_place, a.links_repeat, a.meant_links, a.diagnostics);
  const auto joint = find_or_report(
      a.joints, "joint", "unknown-joint", child.joint, child.joint_place, a.joints_repeat, a.meant_joints,
      a.diagnostics);
  const bool adopted = link && may_adopt(a, parent, *link, child.link_place);
  if (adopted) a.parents[at(*link)] = {parent, child.link_place};
  if (!joint) return;
  std::optional<Place>& use = a.joint_uses[at(*joint)];
  if (use) {
    if (a.joints_repeat) return;
    a.diagnostics
        .error(
            "joint-used-twice", child.joint_place, fmt::format("joint '{}' connects two pairs of links", child.joint))
        .notes.push_back({*use, "first used here"});
    return;
  }
  use = child.joint_place;
  if (!adopted) return;
  a.tree.joints[at(*joint)].parent = parent;
  a.tree.joints[at(*joint)].child = *link;
  a.tree.links[at(*link)].parent_joint = *joint;
  a.tree.links[at(parent)].child_joints.push_back(*joint);
}

void report_unused_joints(Assembly& a) {
  if (a.joints_repeat) return;
  for (std::size_t i = 0; i < a.joint_uses.size(); ++i) {
    const int joint = static_cast<int>(i);
    if (a.joint_uses[i] || a.meant_joints.contains(joint) || a.joints.is_repetition(joint)) continue;
    a.diagnostics.error(
        "joint-unused", a.tree.joints[i].place, fmt::format("joint '{}' connects no links", a.tree.joints[i].name));
  }
}

// Reports a cycle. `loop` lists its links, each followed by its parent.
void report_cycle(Assembly& a, std::vector<int> loop) {
  constexpr std::size_t kShown = 8;
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  std::reverse(loop.begin() + 1, loop.end());  // from parent to child, starting with the first declared
  std::string text;
  for (std::size_t i = 0; i < loop.size() && i < kShown; ++i) {
    text += fmt::format("'{}' -> ", a.tree.links[at(loop[i])].name);
  }
  if (loop.size() > kShown) text += "... -> ";
  const Link& first = a.tree.links[at(loop.front())];
  Diagnostic& error =
      a.diagnostics.error("cycle", first.place, fmt::format("links form a cycle: {}'{}'", text, first.name));
  error.notes.push_back({a.parents[at(loop.front())]->place, fmt::format("'{}' becomes a child here", first.name)});
}

// Checks that every link leads to the base. A link that does not is part of a cycle, lies beyond one, or is in an
// island.
void check_connected(Assembly& a) {
  if (a.links_repeat) return;
  enum class State { unseen, on_this_walk, done };
  std::vector<State> states(a.tree.links.size(), State::unseen);
  states[0] = State::done;
  for (std::size_t i = 1; i < states.size(); ++i) {
    std::vector<int> walk;
    int link = static_cast<int>(i);
    while (states[at(link)] == State::unseen) {
      states[at(link)] = State::on_this_walk;
      walk.push_back(link);
      if (!a.parents[at(link)]) break;
      link = a.parents[at(link)]->parent;
    }
    const bool is_root = !a.parents[at(link)] && link != 0 && !walk.empty() && walk.back() == link;
    if (is_root && !a.meant_links.contains(link) && !a.links.is_repetition(link)) {
      const Link& root = a.tree.links[at(link)];
      a.diagnostics.error(
          "island", root.place,
          fmt::format(
              "link '{}' is not connected to the base '{}': no link has it as a child", root.name,
              a.tree.links[0].name));
    } else if (!is_root && states[at(link)] == State::on_this_walk) {
      report_cycle(a, {std::find(walk.begin(), walk.end(), link), walk.end()});
    }
    for (const int seen : walk) states[at(seen)] = State::done;
  }
}

// Finds the link that carries the joint's rotor.
void resolve_carrier(Assembly& a, std::size_t index) {
  const DescribedJoint& joint = a.description.joints[index];
  std::optional<Rotor>& rotor = a.tree.joints[index].drive.rotor;
  if (!rotor) return;
  const int parent = a.tree.joints[index].parent;
  rotor->carrier = parent;
  if (!joint.rotor_carrier) return;
  const std::string& name = *joint.rotor_carrier;
  const Place& place = joint.drive_places.rotor_carrier;
  const auto link = a.links.find(name);
  if (!link) {
    Diagnostic& error = a.diagnostics.error(
        "unknown-carrier", place,
        fmt::format("the rotor of joint '{}' is on link '{}', which is not declared", joint.name, name));
    if (const auto similar = a.links.nearest_to(name))
      error.hint = fmt::format("did you mean '{}'?", a.links.name_of(*similar));
    return;
  }
  rotor->carrier = *link;
  if (*link == parent || rotor->axis) return;
  if (*link == a.tree.joints[index].child) {
    rotor->axis = {Quantity(), Quantity(), Quantity(1.0)};  // the joint axis, in the axes of the child
    return;
  }
  a.diagnostics
      .error(
          "rotor-without-axis", joint.drive_places.rotor,
          fmt::format(
              "the rotor of joint '{}' needs an axis: that of the joint is not fixed in link '{}'", joint.name, name))
      .hint = fmt::format("write axis = (x, y, z) in coordinates of '{}'", name);
}

// Replaces names by indices. Undeclared elements, and frames that implicit frames hide, are left out.
std::vector<Limb::Element> resolved(
    const std::vector<DescribedLimb::Element>& elements,
    const NameIndex& index,
    const std::vector<UserFrame>* frames = nullptr) {
  std::vector<Limb::Element> result;
  for (const DescribedLimb::Element& element : elements) {
    const std::optional<int> found = index.find(element.name);
    if (found && !(frames && (*frames)[at(*found)].hidden)) result.push_back({element.own, *found});
  }
  return result;
}

void resolve_limbs(Assembly& a) {
  for (const DescribedLimb& limb : a.description.limbs)
    a.tree.limbs.push_back(
        {limb.name, limb.part, a.links.find(limb.first_link).value_or(-1), resolved(limb.links, a.links),
         resolved(limb.joints, a.joints), resolved(limb.frames, a.frames, &a.tree.user_frames)});
}

}  // namespace

std::optional<KinematicTree> build(const Description& description, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  Assembly a{description, diagnostics};
  a.tree.name = description.name;
  a.tree.floating_base = description.floating_base;
  a.tree.uses_passive_forces = description.uses_passive_forces;
  a.tree.parameters = description.parameters;

  declare_elements(a);
  check_names_of_components(a);
  declare_frames(a);
  for (std::size_t i = 0; i < a.link_count(); ++i) resolve_reference(a, i);
  for (std::size_t i = 0; i < a.link_count(); ++i) {
    for (const DescribedChild& child : a.link(i).children) link_child(a, static_cast<int>(i), child);
  }
  report_unused_joints(a);
  check_connected(a);
  if (diagnostics.error_count() == errors_before) {
    for (std::size_t j = 0; j < a.tree.joints.size(); ++j) resolve_carrier(a, j);
  }
  a.tree.couplings = resolve_couplings(description, a.joints, a.joints_repeat, diagnostics);
  a.tree.tendons = resolve_tendons(description, a.joints, a.joints_repeat, diagnostics);
  if (diagnostics.error_count() == errors_before) resolve_loops(description, a.tree, diagnostics);
  if (diagnostics.error_count() == errors_before) resolve_actuators(description, a.tree, diagnostics);
  check_link_ids(description, diagnostics);
  check_mass_properties(description, diagnostics);
  check_drives(description, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;

  resolve_limbs(a);
  place_shapes(a);
  expand_spherical_joints(a.tree);
  a.tree.inertia_defects = inertia_defects(a.tree);
  report_inertia_defects(a.tree, diagnostics);
  return std::move(a.tree);
}

}  // namespace robcogen::model
