#include "model/actuators.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/loop_ends.h"
#include "model/loop_geometry.h"
#include "model/named_frame.h"

namespace robcogen::model {
namespace {

bool has_own_name(const DescribedActuator& described, const KinematicTree& tree, Diagnostics& diagnostics) {
  const auto same_name = [&](const Actuator& other) { return other.name == described.name; };
  const auto other = std::find_if(tree.actuators.begin(), tree.actuators.end(), same_name);
  if (other == tree.actuators.end()) return true;
  diagnostics
      .error("duplicate-actuator", described.place, fmt::format("actuator '{}' is declared twice", described.name))
      .notes.push_back({other->place, "first declared here"});
  return false;
}

// Whether the origins of two frames coincide in every position. An actuator between such frames has no direction.
bool coincide(const KinematicTree& tree, const Frame& first, const Frame& second) {
  constexpr double kSame = 1e-12;
  LoopJoint between;
  between.ends = ends_between(tree, first, second);
  std::vector<double> q, parameters;
  for (std::size_t j = 0; j < tree.joints.size(); ++j) q.push_back(0.7 + 0.1 * static_cast<double>(j));
  for (const Parameter& p : tree.parameters) parameters.push_back(p.default_value.value_or(1.0));
  const LoopPosture now = posture(tree, between, q, parameters);
  return norm(now.points[0] - now.points[1]) < kSame;
}

}  // namespace

void resolve_actuators(const Description& description, KinematicTree& tree, Diagnostics& diagnostics) {
  for (const DescribedActuator& described : description.actuators) {
    std::array<std::optional<Frame>, 2> ends;
    for (std::size_t e = 0; e < 2; ++e)
      ends[e] =
          find_named_frame(tree, described.frames[e], described.frame_places[e], "unknown-actuator-frame", diagnostics);
    if (!ends[0] || !ends[1] || !has_own_name(described, tree, diagnostics)) continue;
    if (const int link = tree.link_of(*ends[0]); link == tree.link_of(*ends[1])) {
      diagnostics
          .error(
              "actuator-on-one-link", described.place,
              fmt::format(
                  "actuator '{}' connects two frames of link '{}'", described.name,
                  tree.links[static_cast<std::size_t>(link)].name))
          .hint = "the frames of an actuator must be on links that move relative to each other";
      continue;
    }
    if (coincide(tree, *ends[0], *ends[1])) {
      diagnostics
          .error(
              "actuator-without-length", described.place,
              fmt::format(
                  "actuator '{}' has no length: the origins of '{}' and '{}' coincide in every position",
                  described.name, described.frames[0], described.frames[1]))
          .hint = "declare frames at the points where the ends of the actuator are attached";
      continue;
    }
    tree.actuators.push_back({described.name, described.frames, described.place});
  }
}

}  // namespace robcogen::model
