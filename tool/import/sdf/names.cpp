#include "import/sdf/names.h"

#include <algorithm>

#include "import/identifier.h"
#include "import/xml/namer.h"

namespace robcogen::import::from_sdf {

Identifiers identifiers_of(const Document& document, const Topology& topology, Diagnostics& diagnostics) {
  Identifiers result;
  xml::Namer namer(diagnostics);
  UniqueNames elements, frames;  // links and joints; links and frames
  result.robot = identifier(document.name.text);
  namer.check_length("model", document.name);
  if (topology.root == kWorldLink) result.world = elements.add("world"), frames.reserve(result.world);
  for (const Link& link : document.links) {
    result.links.push_back(namer.element("link", link.name, link.name.text, "", elements));
    frames.reserve(result.links.back());
  }
  result.joints.resize(document.joints.size());
  result.between.resize(document.joints.size());
  for (std::size_t j = 0; j < document.joints.size(); ++j) {
    const Joint& joint = document.joints[j];
    const bool is_loop = std::find(topology.loops.begin(), topology.loops.end(), static_cast<int>(j)) != topology.loops.end();
    if (joint.type == JointType::fixed && !is_loop) continue;
    const std::string name = namer.element("joint", joint.name, joint.name.text, "_joint", elements);
    if (joint.axes.size() == 2 && !is_loop) {
      result.joints[j] = {elements.add(name + "_axis"), elements.add(name + "_axis2")};
      result.between[j] = elements.add(name + "_link");
    } else {
      result.joints[j] = {name};
    }
  }
  for (const Frame& frame : document.frames)
    result.frames.push_back(
        frame.is_declared ? namer.element("frame", frame.name, frame.name.text, "_frame", frames) : "");
  namer.mention_changes();
  return result;
}

}  // namespace robcogen::import::from_sdf
