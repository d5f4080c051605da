// Constants of the robot.
#include "backend/javascript/text.h"

namespace robcogen::backend::javascript {
namespace {

template <std::size_t kSize>
std::string array(const std::array<double, kSize>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(number(value));
  return "[" + joined(items) + "]";
}

std::string array(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(number(value));
  return "[" + joined(items) + "]";
}

std::array<double, 3> three(const std::array<double, 6>& values, std::size_t from) {
  return {values[from], values[from + 1], values[from + 2]};
}

// An item of a list, in as many lines as it takes.
std::string item(const std::vector<std::string>& members) {
  return wrapped("    {", members, " },");
}

std::string type_of(const JointData& joint) {
  switch (joint.type) {
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

std::vector<std::string> joint_members(const JointData& j) {
  std::vector<std::string> members = {"name: " + quoted(j.name),
                                      "type: " + quoted(type_of(j)),
                                      "parent: " + std::to_string(j.parent),
                                      "child: " + std::to_string(j.child),
                                      "translation: " + array(j.translation),
                                      "rotation: " + array(j.rotation),
                                      "lower: " + number(j.limits.lower),
                                      "upper: " + number(j.limits.upper),
                                      "velocity: " + number(j.limits.velocity),
                                      "effort: " + number(j.limits.effort)};
  if (j.type == JointType::helical) members.push_back("pitch: " + number(j.pitch));
  if (!j.drive) return members;
  const DriveData& d = *j.drive;
  members.push_back(
      "drive: { damping: " + number(d.damping) + ", friction: " + number(d.friction) +
      ", friction_velocity: " + number(d.friction_velocity) + ", armature: " + number(d.armature) +
      ", stiffness: " + number(d.stiffness) + ", rest: " + number(d.rest));
  members.push_back(
      "rotor_inertia: " + number(d.rotor_inertia) + ", rotor_ratio: " + number(d.rotor_ratio) +
      ", rotor_axis: " + array(d.rotor_axis) + ", rotor_carrier: " + std::to_string(d.rotor_carrier) + " }");
  return members;
}

// The member `__proto__` of a literal would be something else.
std::string key(const std::string& name) {
  return name == "__proto__" ? "[" + quoted(name) + "]" : name;
}

std::string indices(const std::vector<LimbData::Element>& elements) {
  std::vector<std::string> members;
  for (const LimbData::Element& e : elements) members.push_back(key(e.own) + ": " + std::to_string(e.index));
  return members.empty() ? "{}" : "{ " + joined(members) + " }";
}

}  // namespace

std::string print_model(const Library& library) {
  std::vector<std::string> documentation = {
      "Constants of the robot, in SI units. Indices count from 0; link 0 is the base, whose parent_joint is -1.",
      "joints: those of joint arrays, with the pose of the joint frame in the frame of the parent link: translation, "
      "then "
      "rotation about the axes x, y', z''; limits.",
      "coupled_joints: those that follow, counted behind the others: factors * q + offset.",
      "links: mass, com, and about the origin of the link frame moments of inertia xx, yy, zz and products of inertia "
      "xy, xz, yz, of positive sign.",
      "frames: the link that a frame moves with, and its pose in the frame of this link.",
      "limbs: of each instance of a part in the document, the index of its first link, and those of its links, its "
      "joints, and its user frames, by their names in the part."};
  if (library.has_spherical_joints())
    documentation.push_back(
        "positions: the elements of q. Of a spherical joint a unit quaternion, scalar part first; in joints it has "
        "three "
        "components, its angular velocities about the axes of the child. Factors multiply q without the scalar parts.");
  if (!library.parameters.empty())
    documentation.push_back(
        "Numbers that depend on parameters are those of the declared values; NaN where a value is missing.");
  std::string text = "\n/**\n" + comment_lines(documentation, " * ") + " */\nexport const model = {\n";
  text += "  name: " + quoted(library.robot) + ",\n";
  text += "  dof: " + std::to_string(library.joints.size()) + ",\n";
  if (library.has_spherical_joints()) {
    std::vector<std::string> names;
    for (const std::string& name : library.positions) names.push_back(quoted(name));
    text += wrapped("  positions: [", names, "],");
  }
  text += std::string("  floating_base: ") + (library.floating_base ? "true" : "false") + ",\n  joints: [\n";
  for (const JointData& j : library.joints) text += item(joint_members(j));
  text += "  ],\n  coupled_joints: [\n";
  for (const CoupledJointData& c : library.coupled) {
    std::vector<std::string> members = joint_members(c.joint);
    members.push_back("factors: " + array(c.factors));
    members.push_back("offset: " + number(c.offset));
    text += item(members);
  }
  text += "  ],\n  links: [\n";
  for (const LinkData& l : library.links)
    text += item(
        {"name: " + quoted(l.name), "parent_joint: " + std::to_string(l.parent_joint), "mass: " + number(l.mass),
         "com: " + array(l.com), "moments: " + array(three(l.inertia, 0)), "products: " + array(three(l.inertia, 3))});
  text += "  ],\n  frames: [\n";
  for (const FrameData& f : library.frames)
    text += item(
        {"name: " + quoted(f.name), "link: " + std::to_string(f.link), "translation: " + array(f.translation),
         "rotation: " + array(f.rotation)});
  text += "  ],\n  limbs: [\n";
  for (const LimbData& l : library.limbs)
    text += item(
        {"name: " + quoted(l.name), "part: " + quoted(l.part), "first_link: " + std::to_string(l.first_link),
         "links: " + indices(l.links), "joints: " + indices(l.joints), "frames: " + indices(l.frames)});
  return text + "  ],\n};\n";
}

}  // namespace robcogen::backend::javascript
