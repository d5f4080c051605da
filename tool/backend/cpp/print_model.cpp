// <name>/model.h: the robot's constants, without Eigen.
#include <algorithm>
#include <array>
#include <cmath>

#include "backend/common/meaning.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"
#include "support/index.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

constexpr const char* kCoupledCount = "kCoupledJointCount";

std::string enumeration(const std::string& name, const std::vector<std::string>& enumerators) {
  if (enumerators.empty()) return "enum class " + name + " : int {};\n";
  std::string result = "enum class " + name + " : int {\n";
  for (std::size_t i = 0; i < enumerators.size(); ++i)
    result += "  " + enumerators[i] + " = " + std::to_string(i) + ",\n";
  return result + "};\n";
}

std::string index_function(const std::string& type, const std::string& parameter) {
  return "constexpr int index(" + type + " " + parameter + ") noexcept {\n  return static_cast<int>(" + parameter +
         ");\n}\n";
}

std::string constant(const std::string& declaration, const std::string& value, const std::string& remark = "") {
  return "inline constexpr " + declaration + " = " + value + ";" + (remark.empty() ? "" : "  // " + remark) + "\n";
}

std::string array(
    const std::string& type,
    const std::string& size,
    const std::string& name,
    const std::vector<std::string>& items,
    const std::vector<std::string>& remarks) {
  return remarked_list("inline constexpr std::array<" + type + ", " + size + "> " + name, items, remarks);
}

template <class Item>
std::string names(const std::string& size, const std::string& name, const std::vector<Item>& items) {
  std::vector<std::string> list, numbers;
  for (const Item& item : items) {
    numbers.push_back(std::to_string(list.size()));
    list.push_back(quoted(item.name));
  }
  return array("const char*", size, name, list, numbers);
}

// The mass of all moving links: it includes the base only if the base floats.
double total_mass(const Library& library) {
  double mass = 0;
  for (const LinkData& link : library.links)
    if (link.parent_joint >= 0 || library.floating_base) mass += link.mass;
  return mass;
}

std::string sizes(const Library& library) {
  const auto count = [](std::size_t n) { return std::to_string(n); };
  if (!library.has_robot()) return constant("int kFrameCount", count(library.frames.size()));
  const std::string coupled =
      library.coupled.empty() ? "" : constant(std::string("int ") + kCoupledCount, count(library.coupled.size()));
  std::string positions;
  if (library.has_own_positions())
    positions = constant("int kPositions", count(library.positions.size()), "elements of q; qd has kDof elements");
  const std::string result = constant("int kDof", count(library.joints.size())) + positions + coupled +
                             constant("int kLinkCount", count(library.links.size())) +
                             constant("int kFrameCount", count(library.frames.size())) +
                             constant("bool kFloatingBase", library.floating_base ? "true" : "false");
  // With parameters, the mass is not constant.
  if (!library.numbers.empty()) return result;
  return result +
         constant("double kTotalMass", print_double(total_mass(library)), "kg, of all links except a fixed base");
}

std::string limit(double value) {
  if (std::isinf(value)) return value < 0 ? "-robcogen::kUnlimited" : "robcogen::kUnlimited";
  return print_double(value);
}

std::string limits(const JointLimits& l) {
  const bool none = std::isinf(l.lower) && std::isinf(l.upper) && std::isinf(l.velocity) && std::isinf(l.effort);
  return "robcogen::JointLimits" +
         (none ? "{}" : braced({limit(l.lower), limit(l.upper), limit(l.velocity), limit(l.effort)}));
}

// All numbers except the rotor's axis, which only a rotor has.
std::array<double, 8> numbers_of(const DriveData& d) {
  return {d.damping, d.friction, d.friction_velocity, d.armature, d.stiffness, d.rest, d.rotor_inertia, d.rotor_ratio};
}

// The drives of joints, which contribute to the dynamics; `{}` for a joint without one.
std::vector<std::string> drives(const std::vector<JointData>& joints) {
  std::vector<std::string> all;
  for (const JointData& joint : joints)
    all.push_back("robcogen::JointDrive" + (joint.drive ? braced(drive_numbers(*joint.drive)) : "{}"));
  return all;
}

// Whether a number of a drive, or a pitch, has no value because it depends on a parameter without default.
bool is_incomplete(const Library& library) {
  const std::vector<JointData> joints = library.all_joints();
  return std::any_of(joints.begin(), joints.end(), [](const JointData& joint) {
    if (std::isnan(joint.pitch)) return true;
    if (!joint.drive) return false;
    const auto is_nan = [](double value) { return std::isnan(value); };
    const std::array<double, 8> numbers = numbers_of(*joint.drive);
    const std::array<double, 3>& axis = joint.drive->rotor_axis;
    return std::any_of(numbers.begin(), numbers.end(), is_nan) || std::any_of(axis.begin(), axis.end(), is_nan);
  });
}

std::string enumerations(const Api& api) {
  const std::string frames = enumeration("Frame", api.frames), index_of_frame = index_function("Frame", "frame");
  if (!api.library->has_robot()) return paragraphs({frames, index_of_frame});
  const bool is_coupled = !api.coupled.empty();
  return paragraphs(
      {(api.positions.empty() ? "// In the order of joint vectors.\n"
        : api.library->has_spherical_joints()
            ? "// In the order of joint vectors, except positions. A spherical joint has three elements.\n"
            : "// In the order of joint vectors, except positions.\n") +
           enumeration("Joint", api.joints),
       api.positions.empty() ? ""
                             : comment("In the order of positions: " + meaning_of_positions(*api.library) + ".") +
                                   enumeration("Position", api.positions),
       is_coupled ? "// Joints that follow the others. Joint vectors have no elements for them.\n" +
                        enumeration("CoupledJoint", api.coupled)
                  : "",
       "// The base first.\n" + enumeration("Link", api.links), frames, index_function("Joint", "joint"),
       api.positions.empty() ? "" : index_function("Position", "position"),
       is_coupled ? index_function("CoupledJoint", "joint") : "", index_function("Link", "link"), index_of_frame});
}

// The constants of these joints: `kJointNames`, ….
std::vector<std::string> tables_of_joints(
    const Api& api,
    const std::vector<JointData>& joints,
    const std::vector<std::string>& enumerators,
    const std::string& size,
    const std::string& prefix) {
  std::vector<std::string> types, parents, children, all_limits, pitches;
  for (const JointData& joint : joints) {
    all_limits.push_back(limits(joint.limits));
    types.push_back(joint_type(joint.type));
    pitches.push_back(model_number(joint.pitch));
    parents.push_back("Link::" + api.links[at(joint.parent)]);
    children.push_back("Link::" + api.links[at(joint.child)]);
  }
  return {
      names(size, prefix + "Names", joints),
      array("robcogen::JointType", size, prefix + "Types", types, enumerators),
      array("Link", size, prefix + "Parents", parents, enumerators),
      array("Link", size, prefix + "Children", children, enumerators),
      "// Lower and upper position, velocity, effort; unlimited where the model gives no limit.\n" +
          array("robcogen::JointLimits", size, prefix + "Limits", all_limits, enumerators),
      api.library->has_drives() ? array("robcogen::JointDrive", size, prefix + "Drives", drives(joints), enumerators)
                                : "",
      api.library->has_pitches() ? "// m/rad; zero for joints that are not helical.\n" +
                                       array("double", size, prefix + "Pitches", pitches, enumerators)
                                 : ""};
}

// How coupled joints follow the others, unless that depends on parameters.
std::string coupling_tables(const Api& api) {
  const Library& library = *api.library;
  if (!library.numbers.empty()) return "";
  std::vector<std::string> factors, offsets;
  bool has_others = false;
  for (const CoupledJointData& coupled : library.coupled) {
    has_others = has_others || std::isnan(coupled.offset);
    std::vector<std::string> row;
    for (const double factor : coupled.factors) row.push_back(model_number(factor));
    factors.push_back("std::array<double, kDof>" + braced(row));
    offsets.push_back(model_number(coupled.offset));
  }
  return paragraphs(
      {"// The position of a coupled joint is its offset plus the sum over the joints of factor times position.\n" +
           std::string(
               has_others ? "// NaN for a joint that follows through a loop: joint_positions computes its position.\n"
                          : "") +
           array("std::array<double, kDof>", kCoupledCount, "kCouplingFactors", factors, api.coupled),
       array("double", kCoupledCount, "kCouplingOffsets", offsets, api.coupled)});
}

std::string joint_tables(const Api& api) {
  const Library& library = *api.library;
  if (!library.has_robot()) return "";
  std::vector<std::string> tables = tables_of_joints(api, library.joints, api.joints, "kDof", "kJoint");
  if (!library.coupled.empty()) {
    for (std::string& table :
         tables_of_joints(api, library.coupled_joints(), api.coupled, kCoupledCount, "kCoupledJoint"))
      tables.push_back(std::move(table));
    tables.push_back(coupling_tables(api));
  }
  return paragraphs(tables);
}

// The index of a joint. Coupled joints are numbered after the others.
std::string joint_index(const Api& api, int joint) {
  const std::size_t dof = api.joints.size();
  if (joint < 0) return "-1";
  if (at(joint) < dof) return "index(Joint::" + api.joints[at(joint)] + ")";
  return "kDof + index(CoupledJoint::" + api.coupled[at(joint) - dof] + ")";
}

std::string link_tables(const Api& api) {
  if (!api.library->has_robot()) return "";
  std::vector<std::string> parents;
  for (const LinkData& link : api.library->links) parents.push_back(joint_index(api, link.parent_joint));
  return paragraphs(
      {names("kLinkCount", "kLinkNames", api.library->links),
       "// Index of the joint that carries the link; -1 for the base.\n" +
           array("int", "kLinkCount", "kLinkParentJoints", parents, api.links)});
}

std::string frame_tables(const Api& api) {
  if (!api.library->has_robot()) return names("kFrameCount", "kFrameNames", api.library->frames);
  std::vector<std::string> links;
  for (const FrameData& frame : api.library->frames) links.push_back("Link::" + api.links[at(frame.link)]);
  return paragraphs(
      {names("kFrameCount", "kFrameNames", api.library->frames),
       "// The link that the frame moves with.\n" + array("Link", "kFrameCount", "kFrameLinks", links, api.frames)});
}

// The elements of all limbs in one array; each limb refers to three ranges of it.
std::string limb_tables(const Api& api) {
  const std::vector<LimbData>& limbs = api.library->limbs;
  if (limbs.empty()) return "";
  std::vector<std::string> elements, remarks;
  const auto add = [&](const std::vector<LimbData::Element>& list, const std::string& remark) {
    const std::string begin = std::to_string(elements.size());
    for (const auto& [own, index] : list) {
      elements.push_back(braced({quoted(own), std::to_string(index)}));
      remarks.push_back(remark);
    }
    return "      " + braced({"kLimbElements + " + begin, std::to_string(list.size())}) + ",\n";
  };
  std::string rows;
  for (const LimbData& limb : limbs) {
    rows += "    robcogen::Limb{\n        " + quoted(limb.name) + ",\n        " + quoted(limb.part) + ",\n        " +
            std::to_string(limb.first_link) + ",\n";
    for (const std::string& list :
         {add(limb.links, limb.name + ": links"), add(limb.joints, limb.name + ": joints"),
          add(limb.frames, limb.name + ": frames")})
      rows += "  " + list;
    rows += "    },\n";
  }
  return paragraphs(
      {"// Instances of parts, in the order of the document.\n" + enumeration("Limb", api.limbs),
       index_function("Limb", "limb"),
       remarked_list("inline constexpr robcogen::LimbElement kLimbElements[]", elements, remarks),
       "// The limbs by index: their links, their joints (indices in joint vectors), their frames.\n"
       "inline constexpr std::array<robcogen::Limb, " +
           std::to_string(limbs.size()) + "> limbs = {\n" + rows + "};\n"});
}

}  // namespace

std::string model_number(double value) {
  return std::isnan(value) ? "std::numeric_limits<double>::quiet_NaN()" : print_double(value);
}

std::string joint_type(JointType type) {
  const std::string scope = "robcogen::JointType::";
  switch (type) {
    case JointType::revolute:
      break;
    case JointType::prismatic:
      return scope + "prismatic";
    case JointType::helical:
      return scope + "helical";
    case JointType::spherical:
      return scope + "spherical";
  }
  return scope + "revolute";
}

std::vector<std::string> drive_numbers(const DriveData& d) {
  std::vector<std::string> items;
  std::size_t last = 0;
  for (const double value : numbers_of(d)) {
    items.push_back(model_number(value));
    if (value != 0.0) last = items.size();
  }
  if (d.rotor_carrier < 0) {
    items.resize(last);
    return items;
  }
  const auto& [x, y, z] = d.rotor_axis;
  items.push_back(braced({model_number(x), model_number(y), model_number(z)}));
  items.push_back(std::to_string(d.rotor_carrier));
  return items;
}

std::string print_model(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  const std::string body = paragraphs(
      {constant("const char* kName", quoted(library.robot)) +
           constant("const char* kModelHash", quoted(library.model_hash)) +
           constant("const char* kGeneratorVersion", quoted(library.generator_version)),
       sizes(library), enumerations(api), joint_tables(api), link_tables(api), frame_tables(api), limb_tables(api)});
  std::vector<std::string> runtime = {"\"robcogen/version.h\""};
  if (library.has_drives()) runtime.emplace_back("\"robcogen/joint_drive.h\"");
  if (library.has_robot()) runtime.insert(runtime.end(), {"\"robcogen/joint_limits.h\"", "\"robcogen/joint_type.h\""});
  if (!library.limbs.empty()) runtime.emplace_back("\"robcogen/limb.h\"");
  return paragraphs(
      {banner(library, path, "constants of the model, without Eigen"), "#pragma once\n",
       includes(
           is_incomplete(library) || !library.loops.empty() ? std::vector<std::string>{"<array>", "<limits>"}
                                                            : std::vector<std::string>{"<array>"}),
       includes(runtime), runtime_check(api), in_namespace(api.space, body)});
}

}  // namespace robcogen::backend::cpp
