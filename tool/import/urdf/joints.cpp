// Checks the types of joints.
#include <fmt/format.h>

#include <algorithm>

#include "import/urdf/describe.h"
#include "support/index.h"

namespace robcogen::import::from_urdf {

namespace {

void check_floating(const Document& document, const Topology& topology, std::size_t j, Diagnostics& diagnostics) {
  const Joint& joint = document.joints[j];
  const int parent = topology.parent[j];
  const Link& root = document.links[at(parent)];
  const auto siblings = std::count(topology.parent.begin(), topology.parent.end(), parent);
  if (parent == topology.root && siblings == 1 && !root.inertial) {
    diagnostics.note(
        "root-left-out", joint.name.place,
        fmt::format(
            "link '{}' is the floating base: root '{}' and joint '{}' are not part of the robot", joint.child.text,
            root.name.text, joint.name.text));
    return;
  }
  diagnostics
      .error(
          "floating-joint", joint.type_place,
          fmt::format(
              "floating joint '{}' is not supported: its parent must be a root without mass and without other children",
              joint.name.text))
      .hint = fmt::format("write link '{}' and the links beyond it to a separate URDF", joint.child.text);
}

constexpr const char* kMimic = "mimic-joint";

// Cycles are found when the couplings of the model are resolved.
void check_mimic(const Document& document, const Joint& joint, Diagnostics& diagnostics) {
  const Mimic& mimic = *joint.mimic;
  if (mimic.joint.text.empty()) return;  // reported
  const std::string follows = fmt::format("joint '{}' mimics joint '{}'", joint.name.text, mimic.joint.text);
  const auto followed = std::find_if(
      document.joints.begin(), document.joints.end(), [&](const Joint& j) { return j.name.text == mimic.joint.text; });
  if (followed == document.joints.end()) {
    std::vector<std::string> names;
    for (const Joint& other : document.joints) names.push_back(other.name.text);
    diagnostics.error(kMimic, mimic.joint.place, follows + ", which is not declared").hint =
        did_you_mean(mimic.joint.text, names);
  } else if (!is_movable(*followed)) {
    diagnostics.error(kMimic, mimic.joint.place, fmt::format("{}, which is {}", follows, name_of(followed->type)))
        .hint = "--free-mimic-joints makes it an independent joint";
  } else if (mimic.multiplier.is_zero()) {
    diagnostics.warning(
        "mimic-stands-still", mimic.joint.place,
        fmt::format("{} with multiplier 0: it stays at {}", follows, print_double(mimic.offset.value())));
  }
}

}  // namespace

void check_joints(
    const Document& document,
    const Topology& topology,
    bool free_mimic_joints,
    Diagnostics& diagnostics) {
  std::string freed;
  Place first_freed;
  for (std::size_t j = 0; j < document.joints.size(); ++j) {
    const Joint& joint = document.joints[j];
    if (joint.type == JointType::floating) check_floating(document, topology, j, diagnostics);
    if (joint.mimic && !free_mimic_joints) {
      check_mimic(document, joint, diagnostics);
    } else if (joint.mimic) {
      if (freed.empty()) first_freed = joint.mimic->joint.place;
      freed += fmt::format("{}'{}'", freed.empty() ? "" : ", ", joint.name.text);
    }
  }
  if (freed.empty()) return;
  diagnostics.note(
      "mimic-joints-freed", first_freed,
      fmt::format("these joints mimic others and are read as independent joints: {}", freed));
}

}  // namespace robcogen::import::from_urdf
