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

std::string names(const std::string& size, const std::string& name, const std::vector<std::string>& items) {
  std::vector<std::string> list, numbers;
  for (const std::string& item : items) {
    numbers.push_back(std::to_string(list.size()));
    list.push_back(quoted(item));
  }
  return array("const char*", size, name, list, numbers);
}

// The mass of all moving links: it includes the base only if the base floats.
double total_mass(const model::KinematicTree& tree) {
  const model::DefaultValues value(tree.parameters);
  double mass = 0;
  for (std::size_t l = tree.floating_base ? 0 : 1; l < at(tree.link_count()); ++l)
    mass += model::mass_properties(tree.links[l], value).mass;
  return mass;
}

std::string sizes(const Library& library) {
  const model::KinematicTree& tree = library.tree;
  const std::string frames = constant("int kFrameCount", std::to_string(library.frames().size()));
  if (!library.has_robot()) return frames;
  const auto count = [](const std::string& name, int n, const std::string& remark = "") {
    return constant("int " + name, std::to_string(n), remark);
  };
  const std::string result =
      count("kDof", tree.dof()) +
      (model::has_own_positions(tree)
           ? count("kPositions", tree.position_count(), "elements of q; qd has kDof elements")
           : "") +
      (tree.couplings.empty() ? "" : count(kCoupledCount, static_cast<int>(tree.couplings.size()))) +
      count("kLinkCount", tree.link_count()) + frames +
      constant("bool kFloatingBase", tree.floating_base ? "true" : "false");
  // With parameters, the mass is not constant.
  if (!library.numbers.empty()) return result;
  return result + constant("double kTotalMass", print_double(total_mass(tree)), "kg, of all links except a fixed base");
}

std::string limit(double value) {
  if (std::isinf(value)) return value < 0 ? "-robcogen::kUnlimited" : "robcogen::kUnlimited";
  return print_double(value);
}

std::string limits(const model::JointLimits& l) {
  const bool none = std::isinf(l.lower) && std::isinf(l.upper) && std::isinf(l.velocity) && std::isinf(l.effort);
  return "robcogen::JointLimits" +
         (none ? "{}" : braced({limit(l.lower), limit(l.upper), limit(l.velocity), limit(l.effort)}));
}

// The drives of joints, which contribute to the dynamics; `{}` for a joint without one.
std::vector<std::string> drives(const model::KinematicTree& tree, const std::vector<int>& joints) {
  std::vector<std::string> all;
  for (const int j : joints) {
    const model::Joint& joint = tree.joints[at(j)];
    all.push_back("robcogen::JointDrive" + (joint.drive.is_absent() ? "{}" : braced(drive_numbers(tree, joint))));
  }
  return all;
}

// Whether a number of a drive, or a pitch, has no value because it depends on a parameter without default.
bool is_incomplete(const model::KinematicTree& tree) {
  const model::DefaultValues value(tree.parameters);
  const auto is_nan = [](double number) { return std::isnan(number); };
  return std::any_of(tree.joints.begin(), tree.joints.end(), [&](const model::Joint& joint) {
    const std::array<double, 8> numbers = model::drive_numbers(joint, value);
    const std::array<double, 3> axis = model::rotor_axis(joint, value);
    return is_nan(value(joint.pitch)) || std::any_of(numbers.begin(), numbers.end(), is_nan) ||
           std::any_of(axis.begin(), axis.end(), is_nan);
  });
}

std::string enumerations(const Api& api) {
  const std::string frames = enumeration("Frame", api.frames), index_of_frame = index_function("Frame", "frame");
  if (!api.library->has_robot()) return paragraphs({frames, index_of_frame});
  const bool is_coupled = !api.coupled.empty();
  return paragraphs(
      {(api.positions.empty() ? "// In the order of joint vectors.\n"
        : !api.library->tree.spherical_joints().empty()
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
    const std::vector<int>& joints,
    const std::vector<std::string>& enumerators,
    const std::string& size,
    const std::string& prefix) {
  const model::KinematicTree& tree = api.library->tree;
  const model::DefaultValues value(tree.parameters);
  std::vector<std::string> types, parents, children, all_limits, pitches;
  for (const int j : joints) {
    const model::Joint& joint = tree.joints[at(j)];
    all_limits.push_back(limits(joint.limits));
    types.push_back(joint_type(joint.type));
    pitches.push_back(model_number(value(joint.pitch)));
    parents.push_back("Link::" + api.links[at(model::parent_link(tree, j))]);
    children.push_back("Link::" + api.links[at(model::child_link(tree, j))]);
  }
  return {
      names(size, prefix + "Names", model::names_of(tree, joints)),
      array("robcogen::JointType", size, prefix + "Types", types, enumerators),
      array("Link", size, prefix + "Parents", parents, enumerators),
      array("Link", size, prefix + "Children", children, enumerators),
      "// Lower and upper position, velocity, effort; unlimited where the model gives no limit.\n" +
          array("robcogen::JointLimits", size, prefix + "Limits", all_limits, enumerators),
      tree.has_drives() ? array("robcogen::JointDrive", size, prefix + "Drives", drives(tree, joints), enumerators)
                        : "",
      tree.has_pitches() ? "// m/rad; zero for joints that are not helical.\n" +
                               array("double", size, prefix + "Pitches", pitches, enumerators)
                         : ""};
}

// How coupled joints follow the others, unless that depends on parameters.
std::string coupling_tables(const Api& api) {
  const model::KinematicTree& tree = api.library->tree;
  if (!api.library->numbers.empty()) return "";
  const model::DefaultValues value(tree.parameters);
  std::vector<std::string> factors, offsets;
  for (const model::Coupling& coupling : tree.couplings) {
    const model::CouplingNumbers numbers = model::coupling_numbers(tree, coupling, value);
    factors.push_back("std::array<double, kDof>" + braced(model_numbers(numbers.factors)));
    offsets.push_back(model_number(numbers.offset));
  }
  return paragraphs(
      {"// The position of a coupled joint is its offset plus the sum over the joints of factor times position.\n" +
           std::string(
               tree.has_closures()
                   ? "// NaN for a joint that follows through a loop: joint_positions computes its position.\n"
                   : "") +
           array("std::array<double, kDof>", kCoupledCount, "kCouplingFactors", factors, api.coupled),
       array("double", kCoupledCount, "kCouplingOffsets", offsets, api.coupled)});
}

std::string joint_tables(const Api& api) {
  const Library& library = *api.library;
  if (!library.has_robot()) return "";
  std::vector<std::string> tables = tables_of_joints(api, library.tree.coordinates(), api.joints, "kDof", "kJoint");
  if (!library.tree.couplings.empty()) {
    const std::vector<int> coupled = model::dependent_joints(library.tree);
    for (std::string& table : tables_of_joints(api, coupled, api.coupled, kCoupledCount, "kCoupledJoint"))
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
  for (const int carrier : model::carrying_joints(api.library->tree)) parents.push_back(joint_index(api, carrier));
  return paragraphs(
      {names("kLinkCount", "kLinkNames", model::link_names(api.library->tree)),
       "// Index of the joint that carries the link; -1 for the base.\n" +
           array("int", "kLinkCount", "kLinkParentJoints", parents, api.links)});
}

std::string frame_tables(const Api& api) {
  const model::KinematicTree& tree = api.library->tree;
  const std::string all = names("kFrameCount", "kFrameNames", api.library->frames());
  if (!api.library->has_robot()) return all;
  std::vector<std::string> links;
  for (const model::Frame& frame : tree.frames()) links.push_back("Link::" + api.links[at(tree.link_of(frame))]);
  return paragraphs(
      {all,
       "// The link that the frame moves with.\n" + array("Link", "kFrameCount", "kFrameLinks", links, api.frames)});
}

// The elements of all limbs in one array; each limb refers to three ranges of it.
std::string limb_tables(const Api& api) {
  const std::vector<model::Limb> limbs = model::listed_limbs(api.library->tree);
  if (limbs.empty()) return "";
  std::vector<std::string> elements, remarks;
  const auto add = [&](const std::vector<model::Limb::Element>& list, const std::string& remark) {
    const std::string begin = std::to_string(elements.size());
    for (const auto& [own, index] : list) {
      elements.push_back(braced({quoted(own), std::to_string(index)}));
      remarks.push_back(remark);
    }
    return "      " + braced({"kLimbElements + " + begin, std::to_string(list.size())}) + ",\n";
  };
  std::string rows;
  for (const model::Limb& limb : limbs) {
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

std::vector<std::string> model_numbers(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(model_number(value));
  return texts;
}

std::string joint_type(model::JointType type) {
  const std::string scope = "robcogen::JointType::";
  switch (type) {
    case model::JointType::revolute:
      break;
    case model::JointType::prismatic:
      return scope + "prismatic";
    case model::JointType::helical:
      return scope + "helical";
    case model::JointType::spherical:
      return scope + "spherical";
  }
  return scope + "revolute";
}

std::vector<std::string> drive_numbers(const model::KinematicTree& tree, const model::Joint& joint) {
  const model::DefaultValues value(tree.parameters);
  std::vector<std::string> items;
  std::size_t last = 0;
  for (const double number : model::drive_numbers(joint, value)) {
    items.push_back(model_number(number));
    if (number != 0.0) last = items.size();
  }
  const int carrier = model::rotor_carrier(joint);
  if (carrier < 0) {
    items.resize(last);
    return items;
  }
  const auto [x, y, z] = model::rotor_axis(joint, value);
  items.push_back(braced({model_number(x), model_number(y), model_number(z)}));
  items.push_back(std::to_string(carrier));
  return items;
}

std::string print_model(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  const std::string body = paragraphs(
      {constant("const char* kName", quoted(library.title())) +
           constant("const char* kModelHash", quoted(library.model_hash)) +
           constant("const char* kGeneratorVersion", quoted(library.generator_version)),
       sizes(library), enumerations(api), joint_tables(api), link_tables(api), frame_tables(api), limb_tables(api)});
  std::vector<std::string> runtime = {"\"robcogen/version.h\""};
  if (library.tree.has_drives()) runtime.emplace_back("\"robcogen/joint_drive.h\"");
  if (library.has_robot()) runtime.insert(runtime.end(), {"\"robcogen/joint_limits.h\"", "\"robcogen/joint_type.h\""});
  if (!library.tree.limbs.empty()) runtime.emplace_back("\"robcogen/limb.h\"");
  return paragraphs(
      {banner(library, path, "constants of the model, without Eigen"), "#pragma once\n",
       includes(
           is_incomplete(library.tree) || !library.tree.loops.empty() ? std::vector<std::string>{"<array>", "<limits>"}
                                                                      : std::vector<std::string>{"<array>"}),
       includes(runtime), runtime_check(api), in_namespace(api.space, body)});
}

}  // namespace robcogen::backend::cpp
