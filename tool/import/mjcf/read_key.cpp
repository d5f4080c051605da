// Reads the first pose in `keyframe`, in which loops are assembled.
#include <fmt/format.h>

#include <limits>

#include "import/mjcf/read.h"

namespace robcogen::import::from_mjcf {

namespace {

std::size_t position_count(const Joint& joint) {
  return joint.type == model::JointType::spherical ? 4 : 1;
}

constexpr std::size_t kPositionsOfFreeJoint = 7;

}  // namespace

bool read_key(const Element& section, Document& document, Diagnostics& diagnostics) {
  for (const Element& key : section.children) {
    const Attribute* positions = key.name == "key" ? find(key, "qpos") : nullptr;
    if (positions == nullptr) continue;
    const auto n = Values(diagnostics).read(*positions, 0, std::numeric_limits<std::size_t>::max());
    if (!n) return false;
    std::size_t count = 0;
    for (const Body& body : document.bodies) {
      if (body.floats()) count += kPositionsOfFreeJoint;
      for (const Joint& joint : body.joints) count += position_count(joint);
    }
    if (n->size() != count) {
      diagnostics.warning(
          "key-size", positions->place,
          fmt::format(
              "this 'qpos' has {} numbers, but the joints of the model have {}: it is ignored", n->size(), count));
      return false;
    }
    std::size_t at = 0;
    for (Body& body : document.bodies) {
      if (body.floats()) at += kPositionsOfFreeJoint;
      for (Joint& joint : body.joints)
        for (std::size_t i = 0; i < position_count(joint); ++i) joint.key.push_back((*n)[at++].value());
    }
    document.key_place = positions->place;
    return true;
  }
  return false;
}

}  // namespace robcogen::import::from_mjcf
