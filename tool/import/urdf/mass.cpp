#include "import/urdf/mass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/index.h"

namespace robcogen::import::from_urdf {

using model::Quantity;

namespace {

// A principal moment may be negative by this fraction of the largest one: rods and plates lie exactly on the limit, and
// rounding to three digits can move them beyond it by this much. (The model warns from 1e-6 on.)
constexpr double kRounding = 1e-2;
// In addition, it may be negative by this fraction of the moment of the link's mass at its reach: the moments of a
// point mass are differences of moments of that size, computed in doubles.
constexpr double kNoise = 1e-11;
const char* const kHint = "--allow-implausible makes this a warning";
const char* const kUnusedHint = "the link does not move: no result depends on it";

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

double length(const std::array<Number, 3>& v) {
  return std::hypot(v[0].value(), v[1].value(), v[2].value());
}

// By link: the largest distance (m) from the origin of its frame to its centre of mass, a joint, or its parent's frame.
std::vector<double> reaches(const Document& document, const Topology* topology) {
  std::vector<double> reach(document.links.size(), 0.0);
  const auto widen = [&](int link, double distance) { reach[at(link)] = std::max(reach[at(link)], distance); };
  for (std::size_t l = 0; l < document.links.size(); ++l)
    if (document.links[l].inertial) widen(static_cast<int>(l), length(document.links[l].inertial->origin.xyz));
  for (std::size_t j = 0; topology != nullptr && j < document.joints.size(); ++j) {
    const double distance = length(document.joints[j].origin.xyz);
    widen(topology->parent[j], distance);
    widen(topology->child[j], distance);
  }
  return reach;
}

// By link: whether a joint moves it. Other links are part of the base.
std::vector<bool> moved(const Document& document, const Topology* topology) {
  std::vector<bool> moved(document.links.size(), topology == nullptr);
  if (topology == nullptr) return moved;
  for (const int link : topology->order) {
    const int j = topology->parent_joint[at(link)];
    if (j >= 0) moved[at(link)] = document.joints[at(j)].type != JointType::fixed || moved[at(topology->parent[at(j)])];
  }
  return moved;
}

// `is_used` tells that the link moves. The mass of a fixed base does not affect any result.
void report(bool is_used, const char* code, const Place& place, const std::string& message, Diagnostics& diagnostics) {
  if (is_used) {
    diagnostics.error(code, place, message).hint = kHint;
  } else {
    diagnostics.warning(code, place, message).hint = kUnusedHint;
  }
}

void check(const Link& link, double reach, bool is_used, Diagnostics& diagnostics) {
  const Inertial& inertial = *link.inertial;
  const double mass = inertial.mass.value();
  if (mass < 0.0) {
    report(
        is_used, "negative-mass", inertial.mass_place,
        fmt::format("the mass of link '{}' is negative: {} kg", link.name.text, print_double(mass)), diagnostics);
  }
  const auto [low, middle, high] = principal_moments(inertial);
  const double tolerance = kRounding * std::abs(high) + kNoise * std::abs(mass) * reach * reach;
  if (low >= -tolerance) return;
  report(
      is_used, "inertia-not-positive", inertial.inertia_place,
      fmt::format(
          "the inertia of link '{}' is not positive semi-definite: principal moments {:.6g}, {:.6g}, {:.6g} kg m^2",
          link.name.text, low, middle, high),
      diagnostics);
}

model::Inertia part_of_body(const PlacedInertial& part) {
  const Inertial& i = *part.inertial;
  model::Inertia result;
  result.mass = Quantity(i.mass);
  result.ixx = Quantity(i.ixx), result.iyy = Quantity(i.iyy), result.izz = Quantity(i.izz);
  // The model stores products of inertia; the tensor contains their negatives.
  result.ixy = Quantity(-i.ixy), result.ixz = Quantity(-i.ixz), result.iyz = Quantity(-i.iyz);
  result.reference = placement_of(part.link * pose_of(i.origin));
  return result;
}

}  // namespace

void check_masses(Document& document, const Topology* topology, bool floating_base, Diagnostics& diagnostics) {
  const std::vector<bool> moves = moved(document, topology);
  for (std::size_t l = 0; l < document.links.size(); ++l) {
    std::optional<Inertial>& inertial = document.links[l].inertial;
    if (!inertial || inertial->has_mass) continue;
    const std::string message = fmt::format("the inertial of link '{}' has no mass", document.links[l].name.text);
    const bool is_used = floating_base || moves[l];
    Diagnostic& diagnostic =
        is_used ? diagnostics.error("missing-element", inertial->mass_place, message)
                : diagnostics.warning("missing-element", inertial->mass_place, message + ": it is left out");
    diagnostic.hint = inertial->mass_hint;
    if (diagnostic.hint.empty())
      diagnostic.hint = is_used ? "write <mass value=\"...\"/>; a link without mass has no 'inertial'" : kUnusedHint;
    if (!is_used) inertial.reset();
  }
}

void check_inertials(const Document& document, const Topology* topology, bool floating_base, Diagnostics& diagnostics) {
  const std::vector<double> reach = reaches(document, topology);
  const std::vector<bool> moves = moved(document, topology);
  for (std::size_t l = 0; l < document.links.size(); ++l)
    if (document.links[l].inertial) check(document.links[l], reach[l], floating_base || moves[l], diagnostics);
}

Pose pose_of(const Origin& origin) {
  return {{Quantity(origin.xyz[0]), Quantity(origin.xyz[1]), Quantity(origin.xyz[2])}, rotation_of_rpy(origin.rpy)};
}

std::optional<model::Inertia> lumped(const std::vector<PlacedInertial>& parts) {
  std::vector<model::Inertia> all;
  for (const PlacedInertial& part : parts) all.push_back(part_of_body(part));
  return model::sum_of(all);
}

}  // namespace robcogen::import::from_urdf
