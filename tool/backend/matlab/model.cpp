// The structs of constants and of parameters, and the overview of a package.
#include <algorithm>

#include "backend/common/constants.h"
#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"

namespace robcogen::backend::matlab {
namespace {

template <class Items, class Text>
std::vector<std::string> texts(const Items& items, Text text) {
  std::vector<std::string> result;
  for (const auto& item : items) result.push_back(text(item));
  return result;
}

// `model.<field> = [a; b];`
std::string column(const std::string& field, const std::vector<std::string>& items) {
  if (items.empty()) return "  model." + field + " = zeros(0, 1);\n";
  std::vector<std::vector<std::string>> rows;
  for (const std::string& item : items) rows.push_back({item});
  return matrix("model." + field, rows);
}

// `model.<field> = {'a'; 'b'};`
std::string names(const std::string& field, const std::vector<std::string>& items) {
  if (items.empty()) return "  model." + field + " = cell(0, 1);\n";
  return wrapped("  model." + field + " = {", items, "};", ";");
}

// `model.<field> = […];`, one column per item.
template <class Items, class Column>
std::string columns(const std::string& field, const Items& items, std::size_t rows, Column column) {
  if (items.empty()) return "  model." + field + " = zeros(" + std::to_string(rows) + ", 0);\n";
  std::vector<std::vector<std::string>> cells(rows);
  for (const auto& item : items)
    for (std::size_t r = 0; r < rows; ++r) cells[r].push_back(number(column(item)[r]));
  return matrix("model." + field, cells);
}

// Whether each joint is of this type.
std::string type_field(const std::string& field, const std::vector<JointData>& joints, JointType type) {
  return column(
      field, texts(joints, [&](const JointData& j) { return std::string(j.type == type ? "true" : "false"); }));
}

std::string joint_fields(const std::vector<JointData>& joints, const std::string& prefix = "") {
  std::string text = names(prefix + "joints", texts(joints, [](const JointData& j) { return quoted(j.name); }));
  const auto field = [&](const std::string& name, auto value) { text += column(prefix + name, texts(joints, value)); };
  text += type_field(prefix + "is_revolute", joints, JointType::revolute);
  field("parent_link", [](const JointData& j) { return std::to_string(j.parent + 1); });
  field("child_link", [](const JointData& j) { return std::to_string(j.child + 1); });
  field("lower_limit", [](const JointData& j) { return number(j.limits.lower); });
  field("upper_limit", [](const JointData& j) { return number(j.limits.upper); });
  field("velocity_limit", [](const JointData& j) { return number(j.limits.velocity); });
  field("effort_limit", [](const JointData& j) { return number(j.limits.effort); });
  text += columns(prefix + "joint_translation", joints, 3, [](const JointData& j) { return j.translation; });
  return text + columns(prefix + "joint_rotation", joints, 3, [](const JointData& j) { return j.rotation; });
}

// The fields of robots with drives.
std::string drive_fields(const std::vector<JointData>& joints, const std::string& prefix = "") {
  std::string text;
  const auto field = [&](const std::string& name, double DriveData::*value) {
    text += column(
        prefix + name, texts(joints, [&](const JointData& j) { return number(j.drive.value_or(DriveData()).*value); }));
  };
  field("damping", &DriveData::damping);
  field("friction", &DriveData::friction);
  field("friction_velocity", &DriveData::friction_velocity);
  field("armature", &DriveData::armature);
  field("stiffness", &DriveData::stiffness);
  field("rest", &DriveData::rest);
  field("rotor_inertia", &DriveData::rotor_inertia);
  field("rotor_ratio", &DriveData::rotor_ratio);
  text += columns(
      prefix + "rotor_axis", joints, 3, [](const JointData& j) { return j.drive.value_or(DriveData()).rotor_axis; });
  return text + column(prefix + "rotor_carrier", texts(joints, [](const JointData& j) {
                         return std::to_string(j.drive.value_or(DriveData()).rotor_carrier + 1);
                       }));
}

// The fields of robots with helical joints.
std::string pitch_fields(const std::vector<JointData>& joints, const std::string& prefix = "") {
  return type_field(prefix + "is_helical", joints, JointType::helical) +
         column(prefix + "pitch", texts(joints, [](const JointData& j) { return number(j.pitch); }));
}

std::string coupling_fields(const Library& library) {
  const std::vector<CoupledJointData>& coupled = library.coupled;
  if (coupled.empty()) return "";
  std::vector<std::vector<std::string>> factors;
  for (const CoupledJointData& c : coupled)
    factors.push_back(texts(c.factors, [](double factor) { return number(factor); }));
  return "\n" + joint_fields(library.coupled_joints(), "coupled_") +
         (library.has_drives() ? drive_fields(library.coupled_joints(), "coupled_") : "") +
         (library.has_pitches() ? pitch_fields(library.coupled_joints(), "coupled_") : "") +
         (coupled.front().factors.empty()
              ? "  model.coupling_factors = zeros(" + std::to_string(coupled.size()) + ", 0);\n"
              : matrix("model.coupling_factors", factors)) +
         column("coupling_offsets", texts(coupled, [](const CoupledJointData& c) { return number(c.offset); }));
}

std::string link_fields(const std::vector<LinkData>& links) {
  std::string text = names("links", texts(links, [](const LinkData& l) { return quoted(l.name); }));
  text += column("parent_joint", texts(links, [](const LinkData& l) { return std::to_string(l.parent_joint + 1); }));
  text += column("mass", texts(links, [](const LinkData& l) { return number(l.mass); }));
  text += columns("com", links, 3, [](const LinkData& l) { return l.com; });
  return text + columns("inertia", links, 6, [](const LinkData& l) { return l.inertia; });
}

std::string frame_fields(const std::vector<FrameData>& frames) {
  std::string text = names("frames", texts(frames, [](const FrameData& f) { return quoted(f.name); }));
  text += column("frame_link", texts(frames, [](const FrameData& f) { return std::to_string(f.link + 1); }));
  text += columns("frame_translation", frames, 3, [](const FrameData& f) { return f.translation; });
  return text + columns("frame_rotation", frames, 3, [](const FrameData& f) { return f.rotation; });
}

std::string limb_fields(const std::vector<LimbData>& limbs) {
  std::string text;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    const std::string field = "limbs(" + std::to_string(i + 1) + ").", limb = "  model." + field;
    const LimbData& l = limbs[i];
    text += limb + "name = " + quoted(l.name) + ";\n" + limb + "part = " + quoted(l.part) + ";\n";
    text += limb + "first_link = " + std::to_string(l.first_link + 1) + ";\n";
    const auto elements = [&](const std::string& what, const std::vector<LimbData::Element>& list) {
      text += column(field + what + "s", texts(list, [](const auto& e) { return std::to_string(e.index + 1); }));
      text += names(field + what + "_names", texts(list, [](const auto& e) { return quoted(e.own); }));
    };
    elements("link", l.links);
    elements("joint", l.joints);
    elements("frame", l.frames);
  }
  return text;
}

// `hyl.transforms.homogeneous.`
std::string dotted(const Library& library, const std::string& scope, const std::string& end = ".") {
  return joined(packages(library, scope), ".") + end;
}

}  // namespace

std::string print_model(const Library& library) {
  std::string text = "function model = model()\n";
  text += comment("MODEL  Constants of robot " + library.robot + ".");
  text += comment("  Units are SI; indices count from 1, parent_joint of the base is 0. The base is the first link.");
  text += comment("  One row for each item, or one column where an item has several numbers:");
  text += comment(
      "  joints: is_revolute, parent_link, child_link, limits of position, velocity and effort, and the placement of "
      "the joint frame in the frame of the parent link: translation, then rotation about the axes x, y', z''.");
  if (library.has_drives())
    text += comment(
        "  joints also have drives: damping; friction, and the velocity below which it falls to zero; armature; "
        "stiffness and rest position of a spring; inertia, ratio and axis of a rotor, and rotor_carrier, a link (0 "
        "without rotor).");
  if (library.has_spherical_joints())
    text += comment(
        "  positions: the elements of q. A spherical joint has a unit quaternion, scalar part first; in joints it has "
        "three components, with is_spherical set, for its angular velocities about the axes of the child. Factors of "
        "couplings multiply q without the scalar parts.");
  if (!library.followers.empty())
    text += comment(
        "  positions: the elements of q. The positions of joints come first, then those of coupled joints that follow "
        "through loops, which close_loops computes.");
  if (library.has_pitches())
    text += comment("  joints also have is_helical and pitch, in m/rad; 0 for joints that are not helical.");
  text += comment(
      "  links: parent_joint, mass, com, and inertia about the origin of the link frame: moments xx, yy, zz, then "
      "products xy, xz, yz of positive sign.");
  text += comment("  frames: frame_link, the link that it moves with, and its placement in the frame of this link.");
  if (!library.limbs.empty())
    text += comment(
        "  limbs: a struct for each instance of a part in the document: its name, its part and first_link, and the "
        "indices of its links, joints (rows of q) and frames, with their names in the part in fields such as "
        "link_names.");
  if (!library.coupled.empty())
    text += comment(
        "  coupled_joints: the same for joints that follow the others, with indices after those of joints; their "
        "positions are coupling_factors * q + coupling_offsets.");
  if (has_closures(library))
    text += comment("  Joints that follow through a loop have NaN there; joint_positions computes their positions.");
  if (!library.parameters.empty())
    text += comment(
        "  Numbers that depend on parameters are computed from the declared values; they are NaN if a value is "
        "missing.");
  text += "\n" + origin(library) + "\n";
  text += "  model.name = " + quoted(library.robot) + ";\n";
  text += "  model.dof = " + std::to_string(library.joints.size()) + ";\n";
  if (library.has_own_positions()) text += names("positions", texts(library.positions, quoted));
  text += std::string("  model.floating_base = ") + (library.floating_base ? "true" : "false") + ";\n";
  text += "\n" + joint_fields(library.joints);
  if (library.has_drives()) text += drive_fields(library.joints);
  if (library.has_pitches()) text += pitch_fields(library.joints);
  if (library.has_spherical_joints()) text += type_field("is_spherical", library.joints, JointType::spherical);
  text += coupling_fields(library) + "\n" + link_fields(library.links) + "\n" + frame_fields(library.frames);
  if (!library.limbs.empty()) text += "\n" + limb_fields(library.limbs);
  return text + "end\n";
}

std::string print_parameters(const Library& library) {
  std::string text = "function parameters = parameters()\n";
  text += comment("PARAMETERS  Values of the parameters as the document declares them.");
  text += comment("  A parameter without a value is NaN: set it before you pass the struct to a function.");
  text += "\n" + origin(library) + "\n";
  const std::vector<std::string> members = fields(library.parameter_names());
  for (std::size_t i = 0; i < members.size(); ++i)
    text += "  parameters." + members[i] + " = " + number(library.parameters[i].default_value) + ";\n";
  return text + "end\n";
}

std::string print_contents(const Library& library, const std::vector<Callable>& callables) {
  const std::string what = library.has_robot() ? "robot " : "model ";
  std::string text = comment("Functions of " + what + library.robot + ".") + "%\n";
  const auto entry = [&](const std::string& name, const std::string& line) {
    text += comment("  " + name + " - " + line, 0, 6);
  };
  const std::string top = dotted(library, "");
  if (library.has_robot()) entry(top + "model", "Constants of the robot.");
  if (!library.parameters.empty()) entry(top + "parameters", "Values of the parameters as the document declares them.");
  std::vector<std::string> scopes;
  for (const Callable& callable : callables) {
    if (callable.scope.empty()) entry(top + callable.name, first_line(callable));
    if (std::find(scopes.begin(), scopes.end(), callable.scope) == scopes.end()) scopes.push_back(callable.scope);
  }
  for (const std::string& scope : scopes) {
    if (scope.empty()) continue;
    text += "%\n" + comment("In package " + dotted(library, scope, ":"));
    for (const Callable& callable : callables)
      if (callable.scope == scope) text += comment("  " + callable.name);
  }
  return text + "\n" + origin(library);
}

}  // namespace robcogen::backend::matlab
