// The attribute `fromto` of geoms and sites: a segment between two points, instead of `pos` and an orientation.
#pragma once

#include <optional>
#include <string>

#include "import/mjcf/orientation.h"

namespace robcogen::import::from_mjcf {

struct Segment {
  std::array<model::Quantity, 3> middle;
  std::array<Number, 3> along = {Number(), Number(), Number::rational(1)};  // from the second point to the first
  double length = 1.0;
};

// Returns nullopt if the element has no `fromto`, or if its shape cannot have one, which is reported. Also reports
// equal points, and a `pos` beside `fromto`.
std::optional<Segment> read_segment(const Element& element, const std::string& shape, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
