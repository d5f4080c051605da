// Removes locked joints from a description.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/about_origin.h"
#include "model/changes.h"
#include "model/locked_joints.h"
#include "model/parametrise.h"
#include "model/plausibility.h"
#include "model/quantities.h"
#include "model/rotations.h"
#include "support/index.h"
#include "support/words.h"

namespace robcogen::model {
namespace {

class Reduction {
 public:
  Reduction(const Description& description, const LockedJoints& locked, const Place& place, Diagnostics& diagnostics)
      : whole_(description), locked_(locked), place_(place), diagnostics_(diagnostics), result_(description) {
    for (std::size_t i = 0; i <= whole_.links.size(); ++i) links_[described_link(whole_, i).name] = i;
    for (std::size_t j = 0; j < whole_.joints.size(); ++j) joints_[whole_.joints[j].name] = j;
    hosts_.resize(links_.size());
  }

  std::optional<Description> run() {
    const std::size_t errors_before = diagnostics_.error_count();
    find_hosts();
    for (const std::size_t link : order_) resolve_reference(link);
    for (const std::size_t link : order_) place_joints(link);
    for (auto link = order_.rbegin(); link != order_.rend(); ++link) join_children(*link);
    for (const std::size_t link : order_) place_frames(link);
    for (const std::size_t link : order_) place_shapes(link);
    for (const std::size_t link : order_)
      if (is_host(link)) lump_masses(link);
    for (DescribedJoint& joint : result_.joints) move_rotor(joint);
    change_couplings();
    shorten_tendons();
    change_loops();
    remove_actuators();
    remove_elements();
    remove_unused_parameters(result_);
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    return std::move(result_);
  }

 private:
  // The link that a link has become part of, and its pose in that link.
  struct Host {
    std::size_t link = 0;
    Placement pose;
    std::vector<std::size_t> guests = {};  // of a host: the links that are part of it, itself first
  };

  const Description& whole_;
  const LockedJoints& locked_;
  const Place& place_;
  Diagnostics& diagnostics_;
  Description result_;
  std::map<std::string, std::size_t> links_, joints_;  // by name
  std::vector<Host> hosts_;                            // by link
  std::vector<std::size_t> order_;                     // links, parents first

  DescribedLink& own(std::size_t link) { return link == 0 ? result_.base : result_.links[link - 1]; }
  bool is_host(std::size_t link) const { return hosts_[link].link == link; }
  const std::optional<LockedJoint>& lock_of(const std::string& joint) const {
    return locked_.joints[joints_.at(joint)];
  }

  // The pose in a host of what is placed in its guest.
  Placement in_host(const Placement& pose, const Placement& placed, const std::string& what) {
    if (const auto result = placed_in(pose, placed)) return *result;
    std::string parameter;
    for (const Placement* p : {&pose, &placed})
      for (const Quantity& q : p->rotation)
        for (const int index : parameters_of(q)) parameter = whole_.parameters[at(index)].name;
    diagnostics_
        .error(
            "lock-parametric-rotation", place_,
            fmt::format("{} cannot be placed beyond a locked joint: its rotation depends on '{}'", what, parameter))
        .hint = fmt::format("lock the parameter, too, at its value: {} = …", parameter);
    return placed;
  }

  void find_hosts() {
    std::vector<std::size_t> pending = {0};
    hosts_[0].link = 0;
    while (!pending.empty()) {
      const std::size_t link = pending.back();
      pending.pop_back();
      order_.push_back(link);
      hosts_[hosts_[link].link].guests.push_back(link);
      const std::vector<DescribedChild>& children = described_link(whole_, link).children;
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        const std::size_t next = links_.at(child->link);
        pending.push_back(next);
        hosts_[next].link = next;
        const auto& lock = lock_of(child->joint);
        if (!lock) continue;
        const Placement& joint = whole_.joints[joints_.at(child->joint)].placement;
        const std::string what = fmt::format("link '{}'", child->link);
        hosts_[next].link = hosts_[link].link;
        hosts_[next].pose = in_host(hosts_[link].pose, in_host(joint, lock->motion, what), what);
      }
    }
  }

  // Mass properties refer to a pose instead of a frame.
  void resolve_reference(std::size_t index) {
    DescribedLink& link = own(index);
    link.id.reset();  // the numbers would have gaps
    if (!link.reference_frame) return;
    for (const DescribedFrame& frame : link.frames)
      if (frame.name == *link.reference_frame) link.inertia->reference = frame.placement;
    link.reference_frame.reset();
  }

  void place_joints(std::size_t link) {
    if (is_host(link)) return;
    for (const DescribedChild& child : described_link(whole_, link).children) {
      Placement& placement = result_.joints[joints_.at(child.joint)].placement;
      placement = in_host(hosts_[link].pose, placement, fmt::format("joint '{}'", child.joint));
    }
  }

  // Children on locked joints are replaced by their own children, which were joined before.
  void join_children(std::size_t link) {
    std::vector<DescribedChild> joined;
    for (const DescribedChild& child : described_link(whole_, link).children) {
      if (!lock_of(child.joint)) {
        joined.push_back(child);
        continue;
      }
      std::vector<DescribedChild>& beyond = own(links_.at(child.link)).children;
      joined.insert(joined.end(), beyond.begin(), beyond.end());
    }
    own(link).children = std::move(joined);
  }

  // Whether an implicit frame has this name, as in the whole robot.
  bool is_implicit(const std::string& frame) const {
    const std::string prefix = implicit_frame_name("");
    if (!frame.starts_with(prefix)) return false;
    const std::string element = frame.substr(prefix.size());
    return links_.contains(element) || joints_.contains(element);
  }

  // Moves the user frames of a link to its host, and adds those that were implicit: its own, and those of its locked
  // joints.
  void place_frames(std::size_t index) {
    const DescribedLink& link = described_link(whole_, index);
    std::vector<DescribedFrame> frames;
    bool has_own_name = link.is_virtual;
    for (DescribedFrame frame : link.frames) {
      has_own_name = has_own_name || frame.name == link.name;
      if (!is_host(index))
        frame.placement = in_host(hosts_[index].pose, frame.placement, fmt::format("frame '{}'", frame.name));
      if (!is_implicit(frame.name)) frames.push_back(std::move(frame));
    }
    if (!is_host(index))
      frames.push_back({implicit_frame_name(link.name), hosts_[index].pose, link.place, has_own_name});
    for (const DescribedChild& child : link.children)
      if (lock_of(child.joint))
        frames.push_back(
            {implicit_frame_name(child.joint), result_.joints[joints_.at(child.joint)].placement, child.joint_place,
             true});
    DescribedLink& host = own(hosts_[index].link);
    if (is_host(index)) host.frames.clear();
    host.frames.insert(host.frames.end(), frames.begin(), frames.end());
  }

  void place_shapes(std::size_t index) {
    if (is_host(index)) return;
    std::vector<Shape>& host = own(hosts_[index].link).shapes;
    for (Shape& shape : own(index).shapes) {
      shape.placement = in_host(hosts_[index].pose, shape.placement, fmt::format("a shape of '{}'", shape.body));
      host.push_back(std::move(shape));
    }
  }

  void lump_masses(std::size_t index) {
    const Host& host = hosts_[index];
    if (host.guests.size() == 1) return;
    std::vector<std::size_t> parts;
    for (const std::size_t guest : host.guests)
      if (own(guest).inertia) parts.push_back(guest);
    DescribedLink& link = own(index);
    if (parts.empty() || (parts.size() == 1 && parts.front() == index)) return;
    RigidBodyInertia sum;
    for (const std::size_t part : parts)
      sum = sum + in_outer_frame(in_link_frame(*own(part).inertia), hosts_[part].pose);
    if (!link.inertia) {
      link.inertia_place = own(parts.front()).inertia_place;
      link.mass_place = own(parts.front()).mass_place;
    }
    link.inertia = about_origin(sum);
  }

  // The carrier of a rotor may have become part of another link.
  void move_rotor(DescribedJoint& joint) {
    if (!joint.drive.rotor || lock_of(joint.name)) return;
    const std::size_t parent = parent_of(joint.name);
    const std::size_t carrier = joint.rotor_carrier ? links_.at(*joint.rotor_carrier) : parent;
    if (is_host(carrier)) return;
    const Host& host = hosts_[carrier];
    auto& axis = joint.drive.rotor->axis;
    if (axis) axis = product(rotation_matrix(host.pose), *axis);
    if (joint.rotor_carrier) joint.rotor_carrier = described_link(whole_, host.link).name;
  }

  std::size_t parent_of(const std::string& joint) const {
    for (std::size_t i = 0; i < hosts_.size(); ++i)
      for (const DescribedChild& child : described_link(whole_, i).children)
        if (child.joint == joint) return i;
    return 0;
  }

  void change_couplings() {
    std::erase_if(result_.couplings, [&](const DescribedCoupling& c) { return lock_of(c.joint).has_value(); });
    for (DescribedCoupling& coupling : result_.couplings) {
      for (const DescribedCoupling::Term& term : coupling.terms)
        if (const auto& lock = lock_of(term.joint)) coupling.offset = coupling.offset + term.factor * lock->position;
      std::erase_if(coupling.terms, [&](const auto& term) { return lock_of(term.joint).has_value(); });
    }
  }

  // What locked joints add to the length of a tendon is constant. A tendon that has no other joints exerts no force.
  void shorten_tendons() {
    for (DescribedTendon& tendon : result_.tendons) {
      for (const DescribedCoupling::Term& term : tendon.terms)
        if (const auto& lock = lock_of(term.joint)) tendon.rest = tendon.rest - term.factor * lock->position;
      std::erase_if(tendon.terms, [&](const auto& term) { return lock_of(term.joint).has_value(); });
    }
    std::erase_if(result_.tendons, [](const DescribedTendon& tendon) { return tendon.terms.empty(); });
  }

  void change_loops() {
    std::erase_if(result_.loops, [&](const DescribedLoop& loop) { return is_among(locked_.loops, loop.name); });
    std::erase_if(result_.independents, [&](const DescribedIndependent& named) {
      return lock_of(named.joint).has_value() || is_among(locked_.rechosen, named.joint);
    });
    for (std::size_t j = 0; j < locked_.assembled.size(); ++j)
      if (locked_.assembled[j]) result_.joints[j].assembled = locked_.assembled[j];
    // The positions are those of the other branch where it is taken.
    for (DescribedLoop& loop : result_.loops)
      if (is_among(locked_.reassembled, loop.name)) loop.takes_other_branch = false;
  }

  // The host of the link that carries the frame of this name.
  std::size_t host_of_frame(const std::string& name) const {
    const std::string prefix = implicit_frame_name("");
    if (name.starts_with(prefix)) {
      const std::string element = name.substr(prefix.size());
      if (const auto link = links_.find(element); link != links_.end()) return hosts_[link->second].link;
      if (joints_.contains(element)) return hosts_[parent_of(element)].link;
    }
    for (std::size_t i = 0; i < hosts_.size(); ++i)
      for (const DescribedFrame& frame : described_link(whole_, i).frames)
        if (frame.name == name) return hosts_[i].link;
    return 0;
  }

  void remove_actuators() {
    std::erase_if(result_.actuators, [&](const DescribedActuator& actuator) {
      if (host_of_frame(actuator.frames[0]) != host_of_frame(actuator.frames[1])) return false;
      diagnostics_.note(
          "locked-actuator", actuator.place,
          fmt::format("actuator '{}' is left out: locked joints connect its ends", actuator.name));
      return true;
    });
  }

  void remove_elements() {
    std::vector<DescribedLink> links;
    for (std::size_t i = 1; i < hosts_.size(); ++i)
      if (is_host(i)) links.push_back(std::move(own(i)));
    result_.links = std::move(links);
    std::erase_if(result_.joints, [&](const DescribedJoint& joint) { return lock_of(joint.name).has_value(); });
    std::erase_if(result_.limbs, [&](const DescribedLimb& limb) {
      const auto first = links_.find(limb.first_link);
      return first != links_.end() && !is_host(first->second);
    });
  }
};

// Copies the diagnostics that satisfy the condition.
template <class Condition>
void append(const Diagnostics& from, Diagnostics& to, Condition is_wanted) {
  for (const Diagnostic& d : from.all()) {
    if (!is_wanted(d)) continue;
    Diagnostic& copy = d.severity == Severity::error     ? to.error(d.code, d.place, d.message)
                       : d.severity == Severity::warning ? to.warning(d.code, d.place, d.message)
                                                         : to.note(d.code, d.place, d.message);
    copy = d;
  }
}

bool was_reported(const Diagnostics& list, const Diagnostic& d) {
  return std::any_of(list.all().begin(), list.all().end(), [&](const Diagnostic& other) {
    return other.code == d.code && other.message == d.message;
  });
}

bool is_inertia_defect(const Diagnostic& d) {
  return is_among(inertia_defect_codes(), d.code);
}

Place first_place(const Changes& changes) {
  return changes.locks.empty() ? changes.kept.front().place : changes.locks.front().name.place;
}

}  // namespace

std::optional<KinematicTree> build(const Description& description, const Changes& changes, Diagnostics& diagnostics) {
  if (changes.empty()) return build(description, diagnostics);
  const std::size_t errors_before = diagnostics.error_count();
  Description whole = description;
  add_parameters(whole, changes.parameters, diagnostics);
  lock_parameters(whole, changes, diagnostics);
  Diagnostics of_whole;
  std::optional<KinematicTree> tree = build(whole, of_whole);
  const bool is_final = !changes.has_locks();
  append(of_whole, diagnostics, [&](const Diagnostic& d) { return is_final || !is_inertia_defect(d); });
  if (!tree || diagnostics.error_count() > errors_before) return std::nullopt;
  if (is_final) return tree;
  const std::optional<LockedJoints> locked = locked_joints(whole, *tree, changes, diagnostics);
  if (!locked) return std::nullopt;
  const std::optional<Description> reduced = Reduction(whole, *locked, first_place(changes), diagnostics).run();
  if (!reduced) return std::nullopt;
  Diagnostics of_rest;
  std::optional<KinematicTree> result = build(*reduced, of_rest);
  append(of_rest, diagnostics, [&](const Diagnostic& d) { return !was_reported(of_whole, d); });
  return result;
}

}  // namespace robcogen::model
