#include "model/kinematic_tree.h"

#include <algorithm>

#include "support/index.h"

namespace robcogen::model {

namespace {

Frame link_frame(const KinematicTree& tree, int link) {
  return {Frame::Kind::link, link, implicit_frame_name(tree.links[at(link)].name)};
}

// Returns the coupling of this joint, or of the first coupled joint after it.
std::vector<Coupling>::const_iterator first_coupling(const std::vector<Coupling>& couplings, int joint) {
  return std::lower_bound(
      couplings.begin(), couplings.end(), joint, [](const Coupling& c, int index) { return c.joint < index; });
}

}  // namespace

bool turns(JointType type) {
  switch (type) {
    case JointType::revolute:
    case JointType::helical:
    case JointType::spherical:
      return true;
    case JointType::prismatic:
      break;
  }
  return false;
}

Quantity slide_of(const Joint& joint) {
  switch (joint.type) {
    case JointType::revolute:
    case JointType::spherical:
      break;
    case JointType::prismatic:
      return Quantity(1.0);
    case JointType::helical:
      return joint.pitch;
  }
  return Quantity();
}

std::string implicit_frame_name(const std::string& element) {
  return "fr_" + element;
}

std::vector<double> KinematicTree::assembled_positions(std::span<const double> parameter_values) const {
  std::vector<double> q;
  for (const Joint& joint : joints) q.push_back(joint.assembled_position());
  for (const Coupling& coupling : couplings) {
    double& position = q[at(coupling.joint)];
    position = evaluate(coupling.offset, parameter_values);
    if (!coupling.is_linear()) continue;
    for (const Coupling::Term& term : coupling.terms)
      position += evaluate(term.factor, parameter_values) * q[at(term.joint)];
  }
  return q;
}

std::vector<int> KinematicTree::topological() const {
  std::vector<int> order;
  order.reserve(joints.size());
  // Uses an explicit stack, because a chain may be deeper than the call stack.
  std::vector<int> pending(links[0].child_joints.rbegin(), links[0].child_joints.rend());
  while (!pending.empty()) {
    const int joint = pending.back();
    pending.pop_back();
    order.push_back(joint);
    const std::vector<int>& beyond = links[at(joints[at(joint)].child)].child_joints;
    pending.insert(pending.end(), beyond.rbegin(), beyond.rend());
  }
  return order;
}

std::vector<int> KinematicTree::coordinates() const {
  std::vector<int> independent;
  auto next = couplings.begin();
  for (int j = 0; j < static_cast<int>(joints.size()); ++j) {
    if (next != couplings.end() && next->joint == j)
      ++next;
    else
      independent.push_back(j);
  }
  return independent;
}

int KinematicTree::coordinate_of(int joint) const {
  return joint - static_cast<int>(first_coupling(couplings, joint) - couplings.begin());
}

bool KinematicTree::has_pitches() const {
  return std::any_of(joints.begin(), joints.end(), [](const Joint& joint) { return joint.type == JointType::helical; });
}

bool KinematicTree::has_drives() const {
  return std::any_of(joints.begin(), joints.end(), [](const Joint& joint) { return !joint.drive.is_absent(); });
}

bool KinematicTree::has_rotors() const {
  return std::any_of(joints.begin(), joints.end(), [](const Joint& joint) { return joint.drive.rotor.has_value(); });
}

bool KinematicTree::has_linear_couplings() const {
  return std::any_of(couplings.begin(), couplings.end(), [](const Coupling& c) { return c.is_linear(); });
}

const Coupling* KinematicTree::coupling_of(int joint) const {
  const auto found = first_coupling(couplings, joint);
  return found == couplings.end() || found->joint != joint ? nullptr : &*found;
}

std::vector<int> independent_joints_first(const KinematicTree& tree) {
  std::vector<int> joints = tree.coordinates();
  for (const Coupling& coupling : tree.couplings) joints.push_back(coupling.joint);
  return joints;
}

std::vector<std::string> position_names(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (const int joint : tree.coordinates()) {
    const Joint& own = tree.joints[at(joint)];
    if (!own.spherical.empty() && own.is_first()) names.push_back(own.spherical + kQuaternionSuffixes[0]);
    names.push_back(own.name);
  }
  for (const int joint : tree.followers_in_q()) names.push_back(tree.joints[at(joint)].name);
  return names;
}

std::vector<int> declared_joints_first(const KinematicTree& tree) {
  std::vector<int> joints = independent_joints_first(tree);
  std::erase_if(joints, [&](int joint) { return !tree.joints[at(joint)].is_first(); });
  return joints;
}

int KinematicTree::first_component_of(int joint) const {
  const Joint& own = joints[at(joint)];
  return own.spherical.empty() ? joint : joint - own.axis;
}

std::vector<int> KinematicTree::spherical_joints() const {
  std::vector<int> first;
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (!joints[j].spherical.empty() && joints[j].is_first()) first.push_back(static_cast<int>(j));
  return first;
}

std::vector<int> KinematicTree::followers_in_q() const {
  std::vector<int> followers;
  for (const Coupling& coupling : couplings)
    if (coupling.closure >= 0 && closures[at(coupling.closure)].method == Closure::Method::iterative)
      followers.push_back(coupling.joint);
  return followers;
}

std::vector<int> KinematicTree::position_elements() const {
  std::vector<int> elements(joints.size(), -1);
  int next = 0;
  for (const int joint : coordinates()) {
    const Joint& own = joints[at(joint)];
    if (!own.spherical.empty() && own.is_first()) ++next;
    elements[at(joint)] = next++;
  }
  for (const int joint : followers_in_q()) elements[at(joint)] = next++;
  return elements;
}

int KinematicTree::link_count() const {
  return static_cast<int>(
      std::count_if(links.begin(), links.end(), [](const Link& link) { return !link.is_repeated; }));
}

std::vector<Frame> KinematicTree::frames() const {
  std::vector<Frame> all;
  all.reserve(links.size() + joints.size() + user_frames.size());
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!links[i].is_repeated) all.push_back(link_frame(*this, static_cast<int>(i)));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i].is_first()) continue;
    all.push_back({Frame::Kind::joint, static_cast<int>(i), implicit_frame_name(joints[i].declared_name())});
  }
  for (std::size_t i = 0; i < user_frames.size(); ++i) {
    if (!user_frames[i].hidden) all.push_back({Frame::Kind::user, static_cast<int>(i), user_frames[i].name});
  }
  return all;
}

std::optional<Frame> KinematicTree::find_frame(const std::string& frame_name) const {
  const std::string prefix = implicit_frame_name("");
  if (frame_name.starts_with(prefix)) {
    const std::string element = frame_name.substr(prefix.size());
    if (const auto link = find_link(element)) return Frame{Frame::Kind::link, *link, frame_name};
    if (const auto joint = find_joint(element)) return Frame{Frame::Kind::joint, *joint, frame_name};
  }
  for (std::size_t i = 0; i < user_frames.size(); ++i) {
    if (user_frames[i].name == frame_name) return Frame{Frame::Kind::user, static_cast<int>(i), frame_name};
  }
  return std::nullopt;
}

std::optional<int> KinematicTree::find_link(const std::string& link_name) const {
  const auto found =
      std::find_if(links.begin(), links.end(), [&](const Link& l) { return l.name == link_name && !l.is_repeated; });
  if (found == links.end()) return std::nullopt;
  return static_cast<int>(found - links.begin());
}

std::optional<int> KinematicTree::find_joint(const std::string& joint_name) const {
  const auto found = std::find_if(
      joints.begin(), joints.end(), [&](const Joint& j) { return j.declared_name() == joint_name && j.is_first(); });
  if (found == joints.end()) return std::nullopt;
  return static_cast<int>(found - joints.begin());
}

int KinematicTree::link_of(const Frame& frame) const {
  switch (frame.kind) {
    case Frame::Kind::joint:
      return joints[at(frame.index)].parent;
    case Frame::Kind::user:
      return user_frames[at(frame.index)].link;
    case Frame::Kind::link:
      break;
  }
  return frame.index;
}

Placement KinematicTree::placement_of(const Frame& frame) const {
  if (frame.kind == Frame::Kind::joint) return joints[at(frame.index)].placement;
  return frame.kind == Frame::Kind::user ? user_frames[at(frame.index)].placement : Placement();
}

namespace {

// Whether this is a user frame with the name of its link.
bool is_named_after_its_link(const KinematicTree& tree, const Frame& frame) {
  return frame.kind == Frame::Kind::user && frame.name == tree.links[at(tree.link_of(frame))].name;
}

bool has_frame_of_its_name(const KinematicTree& tree, int link) {
  const std::optional<Frame> frame = tree.find_frame(tree.links[at(link)].name);
  return frame && is_named_after_its_link(tree, *frame) && tree.link_of(*frame) == link;
}

bool is_identity(const Placement& placement) {
  const auto is_zero = [](const Quantity& q) { return q.is_zero(); };
  return std::all_of(placement.translation.begin(), placement.translation.end(), is_zero) &&
         std::all_of(placement.rotation.begin(), placement.rotation.end(), is_zero);
}

}  // namespace

std::vector<Frame> link_and_user_frames(const KinematicTree& tree) {
  std::vector<Frame> frames;
  for (const Frame& frame : tree.frames()) {
    if (frame.kind == Frame::Kind::joint) continue;
    if (frame.kind == Frame::Kind::user && tree.user_frames[at(frame.index)].by_name_only) continue;
    const int link = tree.link_of(frame);
    const bool is_link = frame.kind == Frame::Kind::link;
    if (is_link && (link == 0 || tree.links[at(link)].is_virtual || has_frame_of_its_name(tree, link))) continue;
    const bool is_the_base =
        link == 0 && is_named_after_its_link(tree, frame) && is_identity(tree.user_frames[at(frame.index)].placement);
    if (!is_the_base) frames.push_back(frame);
  }
  return frames;
}

namespace {

void add_transforms(const KinematicTree& tree, const Frame& frame, DesiredTransforms& desired) {
  const Frame base = link_frame(tree, 0);
  desired.transforms.push_back({base, frame});
  desired.transforms.push_back({frame, base});
}

}  // namespace

std::vector<Frame> end_frames(const KinematicTree& tree) {
  std::vector<Frame> frames = link_and_user_frames(tree);
  std::erase_if(frames, [&](const Frame& frame) {
    const int link = tree.link_of(frame);
    const bool is_of_link = frame.kind == Frame::Kind::link || is_named_after_its_link(tree, frame);
    return is_of_link && link != 0 && tree.links[at(link)].child_joints.size() == 1;
  });
  return frames;
}

DesiredTransforms default_desired(const KinematicTree& tree) {
  return desired_of_frames(tree, end_frames(tree));
}

DesiredTransforms all_desired(const KinematicTree& tree) {
  return desired_of_frames(tree, link_and_user_frames(tree));
}

DesiredTransforms desired_of_frames(const KinematicTree& tree, const std::vector<Frame>& frames) {
  DesiredTransforms desired;
  const Frame base = link_frame(tree, 0);
  for (const Frame& frame : frames) {
    if (frame.name == base.name) continue;
    add_transforms(tree, frame, desired);
    desired.jacobians.push_back({base, frame});
  }
  return desired;
}

}  // namespace robcogen::model
