#include "import/urdf/loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/identifier.h"
#include "import/urdf/link_pair.h"
#include "import/urdf/mass.h"
#include "support/index.h"

namespace robcogen::import::from_urdf {
namespace {

bool is_served(const Loop& loop, Diagnostics& diagnostics) {
  if (loop.type == JointType::revolute || loop.type == JointType::continuous) return true;
  diagnostics
      .error(
          "unsupported-loop-type", loop.type_place,
          fmt::format("loop '{}': type '{}' is not supported", loop.name.text, name_of(loop.type)))
      .hint = "supported are 'revolute' and 'continuous'";
  return false;
}

model::DescribedLink& body_called(const std::string& name, model::Description& description) {
  if (description.base.name == name) return description.base;
  return *std::find_if(
      description.links.begin(), description.links.end(), [&](const auto& body) { return body.name == name; });
}

}  // namespace

std::set<int> add_loop_joints(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics) {
  const std::vector<Carried> carried = carry(document, topology);
  std::set<int> joints;
  for (const Loop& loop : document.loops) {
    if (!is_served(loop, diagnostics)) continue;
    const auto pair = find_link_pair(
        {loop.ends[0].link, loop.ends[1].link}, fmt::format("loop '{}'", loop.name.text), document, topology, carried,
        diagnostics);
    if (!pair) continue;
    model::DescribedLoop result;
    result.name = identifier(loop.name.text);
    result.place = loop.name.place;
    result.type = model::LoopType::hinge;
    for (std::size_t e = 0; e < 2; ++e) {
      const LoopEnd& end = loop.ends[e];
      const Carried& link = carried[at(pair->links[e])];
      result.frames[e] = result.name + (e == 0 ? "_predecessor" : "_successor");
      result.frame_places[e] = end.link.place;
      const Pose pose = link.pose * pose_of(end.origin) * Pose{{}, rotation_to_axis(loop.axis)};
      body_called(identifiers.links[at(link.body)], description)
          .frames.push_back({result.frames[e], placement_of(pose), loop.name.place});
      joints.insert(pair->paths[e].begin(), pair->paths[e].end());
    }
    description.loops.push_back(std::move(result));
  }
  return joints;
}

void add_loops(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const std::vector<bool> followers = may_follow(document);
  const std::set<int> joints = add_loop_joints(document, topology, identifiers, description, diagnostics);
  add_couplings(document, topology, identifiers, followers, description, diagnostics);
  if (diagnostics.error_count() > errors_before) return;
  add_independents(document, identifiers, followers, joints, description, diagnostics);
}

}  // namespace robcogen::import::from_urdf
