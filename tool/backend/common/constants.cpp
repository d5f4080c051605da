#include "backend/common/constants.h"

#include <algorithm>
#include <cmath>

#include "backend/common/meaning.h"

namespace robcogen::backend {
namespace {

std::vector<double> numbers(const std::array<double, 3>& values) {
  return {values.begin(), values.end()};
}

std::string name_of(JointType type) {
  switch (type) {
    case JointType::revolute:
      return "revolute";
    case JointType::prismatic:
      return "prismatic";
    case JointType::helical:
      return "helical";
    case JointType::spherical:
      break;
  }
  return "spherical";
}

Record drive(const DriveData& d) {
  return {
      {{"damping", d.damping},
       {"friction", d.friction},
       {"friction_velocity", d.friction_velocity},
       {"armature", d.armature},
       {"stiffness", d.stiffness},
       {"rest", d.rest}},
      {{"rotor_inertia", d.rotor_inertia},
       {"rotor_ratio", d.rotor_ratio},
       {"rotor_axis", numbers(d.rotor_axis)},
       {"rotor_carrier", d.rotor_carrier}}};
}

std::vector<Constant> joint(const JointData& j) {
  std::vector<Constant> members = {
      {"name", j.name},
      {"type", name_of(j.type)},
      {"parent", j.parent},
      {"child", j.child},
      {"translation", numbers(j.translation)},
      {"rotation", numbers(j.rotation)},
      {"lower", j.limits.lower},
      {"upper", j.limits.upper},
      {"velocity", j.limits.velocity},
      {"effort", j.limits.effort}};
  if (j.type == JointType::helical) members.push_back({"pitch", j.pitch});
  if (j.drive) members.push_back({"drive", drive(*j.drive)});
  return members;
}

std::vector<Constant> coupled_joint(const CoupledJointData& c) {
  std::vector<Constant> members = joint(c.joint);
  members.push_back({"factors", c.factors});
  members.push_back({"offset", c.offset});
  return members;
}

std::vector<Constant> link(const LinkData& l) {
  const std::vector<double> inertia(l.inertia.begin(), l.inertia.end());
  return {
      {"name", l.name},
      {"parent_joint", l.parent_joint},
      {"mass", l.mass},
      {"com", numbers(l.com)},
      {"moments", std::vector<double>(inertia.begin(), inertia.begin() + 3)},
      {"products", std::vector<double>(inertia.begin() + 3, inertia.end())}};
}

std::vector<Constant> frame(const FrameData& f) {
  return {
      {"name", f.name}, {"link", f.link}, {"translation", numbers(f.translation)}, {"rotation", numbers(f.rotation)}};
}

std::vector<Constant> limb(const LimbData& l) {
  const auto indices = [](const std::vector<LimbData::Element>& elements) {
    Record record(elements.empty() ? 0 : 1);
    for (const LimbData::Element& e : elements) record.front().push_back({e.own, e.index});
    return record;
  };
  return {
      {"name", l.name},
      {"part", l.part},
      {"first_link", l.first_link},
      {"links", indices(l.links)},
      {"joints", indices(l.joints)},
      {"frames", indices(l.frames)}};
}

template <class Data>
ConstantList list(
    const std::string& name,
    const std::vector<Data>& data,
    std::vector<Constant> (*members)(const Data&)) {
  ConstantList result{name, {}};
  for (const Data& item : data) result.items.push_back(members(item));
  return result;
}

template <class Data>
std::vector<std::string> names(const std::vector<Data>& data) {
  std::vector<std::string> result;
  for (const Data& item : data) result.push_back(item.name);
  return result;
}

}  // namespace

std::vector<ConstantList> constants(const Library& library) {
  return {
      list("joints", library.joints, joint), list("coupled_joints", library.coupled, coupled_joint),
      list("links", library.links, link), list("frames", library.frames, frame), list("limbs", library.limbs, limb)};
}

bool has_closures(const Library& library) {
  const auto& coupled = library.coupled;
  const auto is_unknown = [](const CoupledJointData& c) { return std::isnan(c.offset); };
  return !library.loops.empty() && std::any_of(coupled.begin(), coupled.end(), is_unknown);
}

std::vector<std::string> describe_constants(const Library& library) {
  std::vector<std::string> lines = {
      "Constants of the robot, in SI units. Indices count from 0; link 0 is the base, whose parent_joint is -1.",
      "joints: in the order of joint arrays, with the pose of the joint frame in the frame of the parent link "
      "(translation, then rotation about the axes x, y', z'') and limits.",
      "coupled_joints: joints that follow the others, at factors * q + offset. Their indices come after those of "
      "joints.",
      "links: mass, com, and moments of inertia xx, yy, zz and products of inertia xy, xz, yz, of positive sign, about "
      "the origin of the link frame.",
      "frames: the link that a frame moves with, and its pose in the frame of this link.",
      "limbs: for each instance of a part in the document, the index of its first link, and the indices of its links, "
      "joints and user frames, by their names in the part."};
  if (library.has_spherical_joints())
    lines.push_back(
        "positions: the elements of q. A spherical joint has a unit quaternion, scalar part first; in joints it has "
        "three components, for its angular velocities about the axes of the child. Factors multiply q without the "
        "scalar parts.");
  if (!library.followers.empty())
    lines.push_back(
        "positions: the elements of q. The positions of joints come first, then those of coupled joints that "
        "close_loops computes.");
  if (has_closures(library))
    lines.push_back(
        "factors and offset are NaN for joints that follow through a loop: joint_positions computes their positions.");
  if (!library.parameters.empty())
    lines.push_back(
        "Numbers that depend on parameters are computed from the declared values; they are NaN if a value is missing.");
  return lines;
}

std::vector<std::pair<std::string, std::size_t>> sizes(const Library& library) {
  std::vector<std::pair<std::string, std::size_t>> all;
  if (library.has_robot()) all = {{"dof", library.joints.size()}, {"link_count", library.links.size()}};
  if (library.has_own_positions()) all.emplace_back("positions", library.positions.size());
  if (!library.parameters.empty()) all.emplace_back("parameter_count", library.parameters.size());
  return all;
}

std::vector<Table> tables(const Library& library) {
  std::vector<Table> all;
  if (library.has_robot()) {
    const std::string but = library.has_spherical_joints() ? " except q; a spherical joint has three elements"
                            : library.has_own_positions()  ? " except q"
                                                           : "";
    all.push_back({"joint_names", "The joints, in the order of all arrays of joints" + but, names(library.joints)});
    if (library.has_own_positions())
      all.push_back({"position_names", "The elements of q: " + meaning_of_positions(library), library.positions});
    all.push_back({"link_names", "The links, the base first", names(library.links)});
  }
  all.push_back({"frame_names", "The frames of transforms", names(library.frames)});
  if (!library.parameters.empty()) all.push_back({"parameter_names", "The parameters", names(library.parameters)});
  if (library.joints.empty()) return all;
  const auto add = [&](const std::string& name, const std::string& what, double JointLimits::*limit) {
    all.push_back({name, what, {}, {}, true});
    for (const JointData& joint : library.joints) all.back().numbers.push_back(joint.limits.*limit);
  };
  add("joint_lower", "Lower position limits: rad or m.", &JointLimits::lower);
  add("joint_upper", "Upper position limits: rad or m.", &JointLimits::upper);
  add("joint_velocity", "Velocity limits: rad/s or m/s.", &JointLimits::velocity);
  add("joint_effort", "Effort limits: N m or N.", &JointLimits::effort);
  return all;
}

}  // namespace robcogen::backend
