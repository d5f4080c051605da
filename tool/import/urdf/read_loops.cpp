// Reads the elements `loop` and `coupling` of URDF+.
#include <fmt/format.h>

#include "import/urdf/joint_attributes.h"
#include "import/urdf/read.h"

namespace robcogen::import::from_urdf {
namespace {

constexpr std::array<const char*, 2> kEnds = {"predecessor", "successor"};

}  // namespace

Loop read_loop(const Element& element, ElementReader& reader) {
  Loop result;
  result.name = reader.name(element, "name");
  const auto type = read_type(
      element, result.name,
      {JointType::revolute, JointType::continuous, JointType::prismatic, JointType::planar, JointType::fixed},
      result.type_place, reader);
  if (type) result.type = *type;
  const Parts own = reader.parts(element, {kEnds[0], kEnds[1], "axis"});
  for (std::size_t e = 0; e < 2; ++e) {
    const Element* end = reader.require_part(element, own, kEnds[e]);
    if (end == nullptr) continue;
    result.ends[e].link = reader.name(*end, "link");
    result.ends[e].origin = reader.origin(reader.parts(*end, {"origin"}));
  }
  if (const auto axis = own.find("axis"); axis != own.end())
    read_axis(*axis->second, fmt::format("loop '{}'", result.name.text), result.axis, reader);
  return result;
}

Coupling read_coupling(const Element& element, ElementReader& reader) {
  Coupling result;
  result.name = reader.name(element, "name");
  const Parts own = reader.parts(element, {kEnds[0], kEnds[1], "ratio"});
  for (std::size_t e = 0; e < 2; ++e)
    if (const Element* end = reader.require_part(element, own, kEnds[e])) result.links[e] = reader.name(*end, "link");
  if (const Element* ratio = reader.require_part(element, own, "ratio"))
    if (const Attribute* value = reader.require(*ratio, "value"))
      result.ratio = reader.numbers(*value, 1, Range::any)[0];
  return result;
}

}  // namespace robcogen::import::from_urdf
