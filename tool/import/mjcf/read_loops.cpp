// Reads `connect` and `weld`, which become loops.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "import/mjcf/anchors.h"
#include "import/mjcf/read.h"
#include "import/rotation_matrix.h"

namespace robcogen::import::from_mjcf {

namespace {

Name name_at(const Element& e, const char* attribute) {
  const Attribute* found = find(e, attribute);
  return found == nullptr ? Name{"", e.place} : Name{found->value, found->place};
}

Pose shift(const std::array<Number, 3>& by) {
  return {quantities(by), {}};
}

class LoopReader {
 public:
  LoopReader(const Element& element, Document& document, Diagnostics& diagnostics)
      : element_(element), document_(document), diagnostics_(diagnostics), values_(diagnostics) {}

  void read() {
    is_weld_ = element_.name == "weld";
    // Without it, the weld does not turn the bodies.
    holds_turns_ = is_weld_ && !values_.scalar(element_, "torquescale", Number::rational(1)).is_zero();
    const bool has_sites = find(element_, "site1") != nullptr || find(element_, "site2") != nullptr;
    if (has_sites ? !has_only_sites() : !has_bodies()) return;
    const auto anchors = has_sites ? anchors_at_sites : anchors_at_bodies;
    const std::vector<Anchor> first =
        anchors(document_, name_at(element_, has_sites ? "site1" : "body1"), diagnostics_);
    const std::vector<Anchor> second =
        anchors(document_, name_at(element_, has_sites ? "site2" : "body2"), diagnostics_);
    for (std::array<Anchor, 2>& ends : paired(document_, first, second)) {
      if (!has_sites) place_anchors(ends);
      add_loop(document_, element_, {"", element_.place, type(), std::move(ends), {}}, diagnostics_);
    }
  }

 private:
  const Element& element_;
  Document& document_;
  Diagnostics& diagnostics_;
  Values values_;
  bool is_weld_ = false, holds_turns_ = false;

  model::LoopType type() const { return holds_turns_ ? model::LoopType::weld : model::LoopType::point; }

  bool has(const char* attribute) {
    if (find(element_, attribute) != nullptr) return true;
    diagnostics_.error(
        "missing-attribute", element_.place, fmt::format("this '{}' has no attribute '{}'", element_.name, attribute));
    return false;
  }

  bool has_bodies() {
    const bool has_first = has("body1");
    return (is_weld_ || has("anchor")) && has_first;
  }

  bool has_only_sites() {
    if (!has("site1") || !has("site2")) return false;
    for (const char* name : {"body1", "body2", "anchor", "relpose"}) {
      const Attribute* other = find(element_, name);
      if (other == nullptr) continue;
      diagnostics_.error(
          "two-kinds-of-ends", other->name_place,
          fmt::format("this '{}' has '{}' beside its sites: its ends are bodies or sites", element_.name, name));
      return false;
    }
    return true;
  }

  // The anchor of a `connect` is in the frame of the first body, that of a `weld` in the frame of the second one. Where
  // it is in the other body follows from how the bodies are drawn, or from `relpose`.
  void place_anchors(std::array<Anchor, 2>& ends) {
    const Pose anchor = shift(values_.triple(element_, "anchor", {}));
    if (is_weld_) {
      const std::optional<Pose> given = relative_pose();
      ends[0].pose = given ? *given : drawn_pose(document_, ends[0].body, ends[1].body) * anchor;
      ends[1].pose = anchor;
    } else {
      ends[0].pose = anchor;
      ends[1].pose = inverse(drawn_pose(document_, ends[0].body, ends[1].body)) * anchor;
    }
    // Axes have no meaning for a point.
    if (!holds_turns_)
      for (Anchor& end : ends) end.pose.rotation = {};
  }

  // `relpose` is where the anchor, which has the axes of the second body, is in the first body. Without an anchor, this
  // is the pose of the second body.
  std::optional<Pose> relative_pose() {
    const Attribute* given = find(element_, "relpose");
    if (given == nullptr) return std::nullopt;
    const std::vector<Number> n = values_.numbers(*given, 7, 7);
    const std::array<long double, 4> q = {n[3].value(), n[4].value(), n[5].value(), n[6].value()};
    // As in MuJoCo, a zero quaternion stands for the poses as drawn.
    if (q == std::array<long double, 4>()) return std::nullopt;
    return Pose{quantities({n[0], n[1], n[2]}), rotation_of_quaternion(q)};
  }
};

}  // namespace

void ignore_constraint(const Element& constraint, const std::string& reason, Diagnostics& diagnostics) {
  diagnostics.warning(
      "constraints-ignored", constraint.place,
      fmt::format(
          "this '{}' is ignored, and the bodies move without it: {}",
          constraint.name == "joint" ? "equality" : constraint.name, reason));
}

void add_loop(Document& document, const Element& element, Loop loop, Diagnostics& diagnostics) {
  bool is_outside = false;
  const std::string fault = fault_of(document, loop.ends, is_outside);
  if (is_outside) return;
  if (!fault.empty()) {
    ignore_constraint(element, fault, diagnostics);
    return;
  }
  if (const Attribute* name = find(element, "name")) loop.name = name->value;
  if (loop.name.empty())
    loop.name = label_of(document, loop.ends[0].body) + "_" + label_of(document, loop.ends[1].body);
  document.loops.push_back(std::move(loop));
}

void read_loop(const Element& element, Document& document, Diagnostics& diagnostics) {
  LoopReader(element, document, diagnostics).read();
}

}  // namespace robcogen::import::from_mjcf
