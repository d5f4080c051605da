// The elements `loop` and `coupling` of URDF+.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {
namespace {

constexpr std::array<std::pair<const char*, JointType>, 5> kLoopTypes = {{
    {"revolute", JointType::revolute},
    {"continuous", JointType::continuous},
    {"prismatic", JointType::prismatic},
    {"planar", JointType::planar},
    {"fixed", JointType::fixed},
}};

constexpr std::array<const char*, 2> kEnds = {"predecessor", "successor"};

class LoopReader : ElementReader {
 public:
  LoopReader(Document& document, Diagnostics& diagnostics)
      : ElementReader(document.source, diagnostics), document_(document) {}

  void read(const Element& root) {
    for (const Element& child : root.children) {
      if (child.name == "loop") document_.loops.push_back(loop(child));
      if (child.name == "coupling") document_.couplings.push_back(coupling(child));
    }
    for (const auto& [name, count] : ignored()) document_.ignored[name] += count;
  }

 private:
  Document& document_;

  Loop loop(const Element& element) {
    Loop result;
    result.name = name(element, "name");
    read_type(element, result);
    const auto own = parts(element, {kEnds[0], kEnds[1], "axis"});
    for (std::size_t e = 0; e < 2; ++e) {
      const Element* end = require_part(element, own, kEnds[e]);
      if (end == nullptr) continue;
      result.ends[e].link = name(*end, "link");
      result.ends[e].origin = origin(parts(*end, {"origin"}));
    }
    if (const auto axis = own.find("axis"); axis != own.end()) read_axis(*axis->second, result);
    return result;
  }

  void read_type(const Element& element, Loop& loop) {
    const Attribute* type = require(element, "type");
    if (type == nullptr) return;
    loop.type_place = place(type->span);
    std::vector<std::string> names;
    for (const auto& [type_name, value] : kLoopTypes) {
      names.emplace_back(type_name);
      if (type->value == type_name) {
        loop.type = value;
        return;
      }
    }
    const std::string hint = did_you_mean(type->value, names);
    diagnostics_
        .error(
            "unknown-loop-type", loop.type_place,
            fmt::format("loop '{}' has unknown type '{}'", loop.name.text, type->value))
        .hint = hint.empty() ? fmt::format("the types are {}", fmt::join(names, ", ")) : hint;
  }

  void read_axis(const Element& element, Loop& loop) {
    const Attribute* xyz = require(element, "xyz");
    if (xyz == nullptr) return;
    const std::size_t errors_before = diagnostics_.error_count();
    loop.axis = triple(*xyz);
    const bool is_zero = std::all_of(loop.axis.begin(), loop.axis.end(), [](const Number& x) { return x.is_zero(); });
    if (!is_zero || diagnostics_.error_count() > errors_before) return;
    diagnostics_.error(
        "zero-axis", place(xyz->span),
        fmt::format("the axis of loop '{}' is zero: it has no direction", loop.name.text));
  }

  Coupling coupling(const Element& element) {
    Coupling result;
    result.name = name(element, "name");
    const auto own = parts(element, {kEnds[0], kEnds[1], "ratio"});
    for (std::size_t e = 0; e < 2; ++e)
      if (const Element* end = require_part(element, own, kEnds[e])) result.links[e] = name(*end, "link");
    if (const Element* ratio = require_part(element, own, "ratio"))
      if (const Attribute* value = require(*ratio, "value")) result.ratio = numbers(*value, 1, Range::any)[0];
    return result;
  }
};

}  // namespace

void read_loops(const Element& root, Document& document, Diagnostics& diagnostics) {
  if (root.name == "robot") LoopReader(document, diagnostics).read(root);
}

}  // namespace robcogen::import::from_urdf
