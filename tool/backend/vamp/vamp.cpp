#include "backend/vamp/vamp.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "backend/cpp/layout.h"
#include "backend/cpp/member_array.h"
#include "backend/cpp/printers.h"
#include "support/index.h"
#include "support/number.h"

namespace robcogen::backend::vamp {
namespace {

using cpp::quoted;
using model::Joint;
using model::KinematicTree;

// Joints that turn without limits are planned within one turn, as VAMP does for its robots.
model::JointLimits limits_of(const Joint& joint) {
  model::JointLimits limits = joint.limits;
  if (!model::turns(joint.type)) return limits;
  if (!std::isfinite(limits.lower)) limits.lower = -std::numbers::pi;
  if (!std::isfinite(limits.upper)) limits.upper = std::numbers::pi;
  return limits;
}

// `panda_arm` -> `PandaArm`. Capitals remain, so that VAMP's own name UR5 can be had. Members have other names.
std::string structure_name(const std::string& name) {
  std::string result;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') result += begins && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    begins = c == '_';
  }
  if (result.empty() || (result.front() >= '0' && result.front() <= '9')) return "Robot" + result;
  static const std::set<std::string> members = {
      "Configuration", "ConfigurationArray", "ConfigurationBlock", "ConfigurationBuffer", "Debug", "Shapes", "Spheres"};
  return members.contains(result) ? result + "Robot" : result;
}

std::string number(double value) {
  return print_double(static_cast<double>(static_cast<float>(value))) + "f";
}

// The groups of the parts that are checked against one of the end effector's link.
std::vector<std::string> attachment_groups(const CollisionCheck& check, int link) {
  std::set<int> parts;
  for (const auto& [a, b] : check.shapes.pairs) {
    if (check.shapes.parts[at(a)].link == link) parts.insert(b);
    if (check.shapes.parts[at(b)].link == link) parts.insert(a);
  }
  std::vector<std::string> result;
  for (const int k : parts) {
    const model::CollisionTree::Part& part = check.shapes.parts[at(k)];
    for (int g = part.first; g < part.first + part.count; ++g) result.push_back(std::to_string(g));
  }
  return result;
}

const cpp::Callable& pose_of(const cpp::Api& api, const std::string& frame) {
  const KinematicTree& tree = api.library->tree;
  for (const cpp::Callable& c : api.callables) {
    const Function& f = *c.function;
    if (f.scope != "transforms::homogeneous" || f.right != frame || !f.derivatives.empty()) continue;
    if (tree.link_of(*tree.find_frame(f.left)) == 0) return c;
  }
  throw std::logic_error("the library has no transform of the end effector");
}

}  // namespace

const std::vector<std::string>& groups() {
  static const std::vector<std::string> list = {"transforms", "collision"};
  return list;
}

void check(const KinematicTree& tree, Diagnostics& diagnostics) {
  const auto refuse = [&](const Place& place, const std::string& what, const std::string& hint) {
    diagnostics.error("vamp-robot", place, "--vamp: " + what).hint = hint;
  };
  const std::string fixed = "VAMP plans for robots with a fixed base whose joints have one position each";
  const Place& robot = tree.links.front().place;
  if (tree.floating_base) refuse(robot, "the base of robot '" + tree.name + "' floats", fixed);
  if (!tree.followers_in_q().empty())
    refuse(robot, "joints of robot '" + tree.name + "' follow others through loops", fixed);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const Joint& joint = tree.joints[j];
    const bool is_coupled = tree.coupling_of(static_cast<int>(j)) != nullptr;
    if (!joint.spherical.empty() && joint.is_first())
      refuse(joint.place, "joint '" + joint.declared_name() + "' is spherical", fixed);
    const model::JointLimits limits = limits_of(joint);
    if (joint.spherical.empty() && !is_coupled && !(std::isfinite(limits.lower) && std::isfinite(limits.upper)))
      refuse(joint.place, "joint '" + joint.name + "' has no limits", "VAMP samples positions between limits");
  }
  for (const model::Parameter& parameter : tree.parameters)
    if (model::is_kinematics(parameter))
      refuse(robot, "parameter '" + parameter.name + "' moves shapes", "its value must be in the document");
}

std::string output(const std::string& name) {
  std::string path = "vamp/robots/";
  for (const char c : name) path += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return path + ".hh";
}

OutputFile print(const Library& library, const std::string& end_effector) {
  const cpp::Api api = cpp::api(library);
  const KinematicTree& tree = library.tree;
  const std::string path = output(library.name), folder = cpp::folder(library), name = structure_name(library.name);
  std::vector<std::string> names, low, range;
  for (const int j : tree.coordinates()) {
    const model::JointLimits limits = limits_of(tree.joints[at(j)]);
    names.push_back(quoted(tree.joints[at(j)].name));
    low.push_back(number(limits.lower));
    range.push_back(number(limits.upper - limits.lower));
  }
  const int link = tree.link_of(*tree.find_frame(end_effector));
  const std::string traits =
      "struct VampTraits {\n"
      "  using Shapes = CollisionShapes;\n"
      "  static constexpr const char* kName = " +
      quoted(library.name) + ";\n" + "  static constexpr const char* kEndEffector = " + quoted(end_effector) + ";\n" +
      cpp::member_array("std::string_view", "kJointNames", names) +
      "  // rad, m: the lower limits, and the distances of the upper ones.\n" +
      cpp::member_array("float", "kLow", low) + cpp::member_array("float", "kRange", range) +
      "  // Groups of spheres that what is attached to the end effector must not touch.\n" +
      cpp::member_array("int", "kAttachmentGroups", attachment_groups(*library.collision_check, link)) +
      "  template <class Scalar>\n"
      "  static void end_effector(const Scalar* q, Scalar* X) noexcept {\n"
      "    kernel::" +
      pose_of(api, end_effector).kernel + "(q, X);\n  }\n};\n";
  return {
      path,
      cpp::paragraphs(
          {cpp::banner(library, path, "the robot for the motion planner VAMP"), "#pragma once\n",
           cpp::includes({"<array>", "<string_view>"}),
           cpp::includes(
               {"\"robcogen/vamp.h\"", quoted(cpp::header_path(folder, cpp::kCollisionCheck)),
                quoted(cpp::kernel_path(folder, "transforms"))}),
           cpp::in_namespace(api.space, traits),
           cpp::in_namespace(
               "vamp::robots", "struct " + name + " : robcogen::VampRobot<::" + api.space + "::VampTraits> {};\n")})};
}

}  // namespace robcogen::backend::vamp
