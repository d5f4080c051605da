#include "import/body_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace robcogen::import {
namespace {

constexpr double kLargest = 1e6;  // m; squares of squares of lengths are in range in single precision

// A mesh that several shapes have is reported once.
bool was_reported(const Diagnostics& diagnostics, const Diagnostic& d) {
  return std::any_of(diagnostics.all().begin(), diagnostics.all().end(), [&](const Diagnostic& other) {
    return other.code == d.code && other.place.source == d.place.source &&
           other.place.span.begin == d.place.span.begin && other.message == d.message;
  });
}

}  // namespace

model::Shape placed(const BodyShape& own, const std::string& body, const Pose& body_in_link) {
  model::Shape result = own.shape;
  result.body = body;
  result.placement = placement_of(body_in_link * own.pose);
  return result;
}

// With half axes a >= r >= s, the section of the ellipsoid at x along the longest axis is inside a circle of radius
// r sqrt(1 - x^2 / a^2), which is less than that of the capsule: sqrt(r^2 - (x - h)^2) beyond h = a - r.
void set_ellipsoid(BodyShape& shape, const std::array<double, 3>& half_axes) {
  const auto axis = static_cast<std::size_t>(std::max_element(half_axes.begin(), half_axes.end()) - half_axes.begin());
  const double radius = std::max(half_axes[(axis + 1) % 3], half_axes[(axis + 2) % 3]);
  std::array<Number, 3> direction;
  direction[axis] = Number::rational(1);
  shape.shape.kind = half_axes[axis] > radius ? model::Shape::Kind::capsule : model::Shape::Kind::sphere;
  shape.shape.size = {radius, 2 * (half_axes[axis] - radius), 0};
  shape.pose = shape.pose * Pose{{}, rotation_to_axis(direction)};
}

std::string fault_of_length(double length) {
  if (!(length > 0)) return "is not positive";
  return length > kLargest ? "is more than 1e6 m" : "";
}

bool is_too_large(const model::TriangleMesh& mesh, const std::array<double, 3>& scale) {
  for (const auto& vertex : mesh.vertices)
    for (std::size_t k = 0; k < 3; ++k)
      if (!(std::abs(vertex[k] * scale[k]) <= kLargest)) return true;
  return false;
}

bool add_findings(const Diagnostics& found, bool is_needed, Diagnostics& diagnostics) {
  for (Diagnostic d : found.all()) {
    if (d.severity == Severity::error && !is_needed) {
      d.severity = Severity::warning;
      d.message += ": the shape is left out";
    }
    if (was_reported(diagnostics, d)) continue;
    const bool is_error = d.severity == Severity::error;
    (is_error ? diagnostics.error(d.code, d.place, d.message) : diagnostics.warning(d.code, d.place, d.message)) = d;
  }
  return !found.has_errors();
}

}  // namespace robcogen::import
