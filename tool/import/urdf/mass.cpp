#include "import/urdf/mass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robcogen::import::from_urdf {

using model::Quantity;

namespace {

// A principal moment may be negative by this part of the largest one: documents round their numbers, and rods and point
// masses lie exactly on the limit.
constexpr double kMomentTolerance = 1e-6;
const char* const kHint = "--allow-implausible makes a warning of it";

// Eigenvalues of the tensor in ascending order, as the roots of its characteristic polynomial (Smith 1961).
std::array<double, 3> principal_moments(const Inertial& i) {
  const double xy = i.ixy.value(), xz = i.ixz.value(), yz = i.iyz.value();
  const double mean = i.ixx.value() / 3.0 + i.iyy.value() / 3.0 + i.izz.value() / 3.0;
  const double x = i.ixx.value() - mean, y = i.iyy.value() - mean, z = i.izz.value() - mean;
  const double spread = std::sqrt((x * x + y * y + z * z + 2.0 * (xy * xy + xz * xz + yz * yz)) / 6.0);
  if (spread == 0.0) return {mean, mean, mean};
  const auto scaled = [&](double value) { return value / spread; };
  const double a = scaled(x), b = scaled(y), c = scaled(z), d = scaled(xy), e = scaled(xz), f = scaled(yz);
  const double half_determinant = (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e)) / 2.0;
  const double angle = std::acos(std::clamp(half_determinant, -1.0, 1.0)) / 3.0;
  const double high = mean + 2.0 * spread * std::cos(angle);
  const double low = mean + 2.0 * spread * std::cos(angle + 2.0 * std::numbers::pi / 3.0);
  return {low, 3.0 * mean - low - high, high};
}

void check(const Link& link, Diagnostics& diagnostics) {
  const Inertial& inertial = *link.inertial;
  if (inertial.mass.value() < 0.0) {
    diagnostics
        .error(
            "negative-mass", inertial.place,
            fmt::format("mass of link '{}' is negative: {} kg", link.name.text, print_double(inertial.mass.value())))
        .hint = kHint;
  }
  const auto [low, middle, high] = principal_moments(inertial);
  if (low >= -kMomentTolerance * std::max(std::abs(low), std::abs(high))) return;
  diagnostics
      .error(
          "inertia-not-positive", inertial.place,
          fmt::format(
              "inertia of link '{}' is not positive semi-definite: principal moments {:.6g}, {:.6g}, {:.6g} kg m^2",
              link.name.text, low, middle, high))
      .hint = kHint;
}

model::Inertia part_of_body(const PlacedInertial& part) {
  const Inertial& i = *part.inertial;
  model::Inertia result;
  result.mass = Quantity(i.mass);
  result.ixx = Quantity(i.ixx), result.iyy = Quantity(i.iyy), result.izz = Quantity(i.izz);
  // The model has products of inertia, a tensor has them with negative sign.
  result.ixy = Quantity(-i.ixy), result.ixz = Quantity(-i.ixz), result.iyz = Quantity(-i.iyz);
  result.reference = placement_of(part.link * pose_of(i.origin));
  return result;
}

void add(model::RigidBodyInertia& sum, const model::RigidBodyInertia& part) {
  sum.mass = sum.mass + part.mass;
  for (std::size_t k = 0; k < 3; ++k) sum.first_moment[k] = sum.first_moment[k] + part.first_moment[k];
  sum.ixx = sum.ixx + part.ixx, sum.iyy = sum.iyy + part.iyy, sum.izz = sum.izz + part.izz;
  sum.ixy = sum.ixy + part.ixy, sum.ixz = sum.ixz + part.ixz, sum.iyz = sum.iyz + part.iyz;
}

}  // namespace

void check_inertials(const Document& document, Diagnostics& diagnostics) {
  for (const Link& link : document.links)
    if (link.inertial) check(link, diagnostics);
}

Pose pose_of(const Origin& origin) {
  return {{Quantity(origin.xyz[0]), Quantity(origin.xyz[1]), Quantity(origin.xyz[2])}, rotation_of_rpy(origin.rpy)};
}

std::optional<model::Inertia> lumped(const std::vector<PlacedInertial>& parts) {
  if (parts.empty()) return std::nullopt;
  model::RigidBodyInertia sum;
  model::Inertia result;
  for (const PlacedInertial& part : parts) {
    const model::Inertia own = part_of_body(part);
    add(sum, model::in_link_frame(own));
    result.com = own.reference->translation;
  }
  result.mass = sum.mass;
  if (parts.size() > 1) {
    for (std::size_t k = 0; k < 3; ++k)
      result.com[k] = sum.mass.is_zero() ? Quantity() : sum.first_moment[k] / sum.mass;
  }
  result.ixx = sum.ixx, result.iyy = sum.iyy, result.izz = sum.izz;
  result.ixy = sum.ixy, result.ixz = sum.ixz, result.iyz = sum.iyz;
  return result;
}

}  // namespace robcogen::import::from_urdf
