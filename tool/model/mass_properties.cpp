#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "model/plausibility.h"
#include "model/principal_moments.h"

namespace robcogen::model {

namespace {

// A moment may violate the triangle inequality or positivity by this fraction of the largest moment: documents contain
// rounded numbers, and rods and plates lie exactly on the limit.
constexpr double kMomentTolerance = 1e-6;
// The rounding error of subtracting m |c|^2, by the author of the moments and here, relative to the given moments and
// to the moment of the link's mass at its reach. Point masses have no other scale.
constexpr double kNoise = 1e-12;

using Matrix = SymmetricMatrix;

bool is_constant(const Inertia& i) {
  const auto all = {&i.mass, &i.com[0], &i.com[1], &i.com[2], &i.ixx, &i.iyy, &i.izz, &i.ixy, &i.ixz, &i.iyz};
  return std::all_of(all.begin(), all.end(), [](const Quantity* q) { return q->is_constant(); });
}

// The tensor as given, about the origin of the reference frame. Principal moments do not depend on the axes, so the
// axes of the reference frame are good enough.
Matrix given_tensor(const Inertia& i) {
  const double xy = -evaluate(i.ixy), xz = -evaluate(i.ixz), yz = -evaluate(i.iyz);
  return {{{evaluate(i.ixx), xy, xz}, {xy, evaluate(i.iyy), yz}, {xz, yz, evaluate(i.izz)}}};
}

constexpr const char* kByDefault = ", by the default values of parameters";

void check_mass(const DescribedLink& link, const std::vector<Parameter>& parameters, Diagnostics& diagnostics) {
  const Quantity& mass = link.inertia->mass;
  const double value = value_at_defaults(mass, parameters).value_or(0.0);
  if (value < 0.0) {
    diagnostics.warning(
        "negative-mass", link.mass_place,
        fmt::format(
            "the mass of link '{}' is negative: {} kg{}", link.name, print_double(value),
            mass.is_constant() ? "" : kByDefault));
  } else if (mass.is_zero()) {
    const Inertia& i = *link.inertia;
    const auto moments = {i.ixx, i.iyy, i.izz, i.ixy, i.ixz, i.iyz};
    const bool has_moments =
        std::any_of(moments.begin(), moments.end(), [](const Quantity& m) { return !m.is_zero(); });
    diagnostics.warning("zero-mass", link.mass_place, fmt::format("the mass of link '{}' is zero", link.name)).hint =
        has_moments ? "its moments of inertia are part of the dynamics: write its mass, too"
                    : "a link without mass and moments needs no inertia: leave it out";
  }
}

enum class Verdict { plausible, not_positive, unequal };

// `moments` in ascending order.
Verdict judge(const std::array<double, 3>& moments, double noise) {
  const auto& [low, middle, high] = moments;
  const double tolerance = kMomentTolerance * std::max(std::abs(low), std::abs(high)) + noise;
  if (low < -tolerance) return Verdict::not_positive;
  return high > low + middle + tolerance ? Verdict::unequal : Verdict::plausible;
}

// The length of a constant vector; zero for a vector that depends on parameters.
double length(const std::array<Quantity, 3>& v) {
  for (const Quantity& component : v)
    if (!component.is_constant()) return 0.0;
  return std::hypot(evaluate(v[0]), evaluate(v[1]), evaluate(v[2]));
}

// By joint: its distance from the origin of the parent link's frame (m).
using Distances = std::map<std::string, double>;

// The largest distance (m) from the origin of the link frame to the centre of mass, a user frame, a child joint, or the
// origin of the parent frame.
double reach_of(const DescribedLink& link, const Distances& distances, double from_parent) {
  double reach = std::max(from_parent, length(link.inertia->com));
  for (const DescribedFrame& frame : link.frames) reach = std::max(reach, length(frame.placement.translation));
  for (const DescribedChild& child : link.children)
    if (const auto found = distances.find(child.joint); found != distances.end())
      reach = std::max(reach, found->second);
  return reach;
}

// Returns the mass properties at the default values of parameters. Those without a default remain.
Inertia at_defaults(Inertia inertia, const std::vector<Parameter>& parameters) {
  const auto replace = [&](Quantity& q) {
    if (q.is_constant()) return;
    if (const auto value = value_at_defaults(q, parameters)) q = Quantity(*value);
  };
  for (Quantity* q :
       {&inertia.mass, &inertia.ixx, &inertia.iyy, &inertia.izz, &inertia.ixy, &inertia.ixz, &inertia.iyz})
    replace(*q);
  for (Quantity& q : inertia.com) replace(q);
  return inertia;
}

void check_moments(
    const DescribedLink& link,
    double reach,
    const std::vector<Parameter>& parameters,
    Diagnostics& diagnostics) {
  const Inertia inertia = at_defaults(*link.inertia, parameters);
  const double mass = is_constant(inertia) ? evaluate(inertia.mass) : -1.0;
  if (mass < 0.0) return;
  const std::array<double, 3> given = principal_moments(given_tensor(inertia));
  const std::array<double, 3> central = principal_moments(central_tensor(inertia));
  const double noise = kNoise * (std::abs(given[2]) + mass * reach * reach);
  const Verdict verdict = judge(central, noise);
  if (verdict == Verdict::plausible) return;

  const std::string moments = fmt::format(
      "{:.6g}, {:.6g}, {:.6g} kg m^2{}", central[0], central[1], central[2],
      is_constant(*link.inertia) ? "" : kByDefault);
  Diagnostic& warning =
      verdict == Verdict::not_positive
          ? diagnostics.warning(
                "inertia-not-positive", link.inertia_place,
                fmt::format(
                    "the inertia of link '{}' about its centre of mass is not positive semi-definite: principal "
                    "moments {}",
                    link.name, moments))
          : diagnostics.warning(
                "triangle-inequality", link.inertia_place,
                fmt::format(
                    "the inertia of link '{}' is not that of a body: the largest principal moment about the centre of "
                    "mass exceeds the sum of the others ({})",
                    link.name, moments));
  if (judge(given, noise) == Verdict::plausible) {
    warning.hint = "moments of inertia are given about the origin of the frame; are these about the centre of mass?";
  }
}

}  // namespace

Matrix central_tensor(const Inertia& i) {
  Matrix tensor = given_tensor(i);
  const double m = evaluate(i.mass);
  const std::array<double, 3> c = {evaluate(i.com[0]), evaluate(i.com[1]), evaluate(i.com[2])};
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
    tensor[j][j] -= m * (c[k] * c[k] + c[l] * c[l]);
    tensor[j][k] += m * c[j] * c[k];
    tensor[k][j] += m * c[j] * c[k];
  }
  return tensor;
}

void check_mass_properties(const Description& description, Diagnostics& diagnostics) {
  Distances distances, from_parent;  // the latter by link
  for (const DescribedJoint& joint : description.joints)
    distances.insert({joint.name, length(joint.placement.translation)});
  for (std::size_t i = 0; i <= description.links.size(); ++i)
    for (const DescribedChild& child : described_link(description, i).children)
      if (const auto found = distances.find(child.joint); found != distances.end())
        from_parent.insert({child.link, found->second});
  for (std::size_t i = 0; i <= description.links.size(); ++i) {
    const DescribedLink& link = described_link(description, i);
    const bool is_used = i > 0 || description.floating_base;
    if (!link.inertia || !is_used) continue;
    check_mass(link, description.parameters, diagnostics);
    const auto distance = from_parent.find(link.name);
    const double to_parent = distance == from_parent.end() ? 0.0 : distance->second;
    check_moments(link, reach_of(link, distances, to_parent), description.parameters, diagnostics);
  }
}

}  // namespace robcogen::model
