// Reads the masses of bodies.
#include <fmt/format.h>

#include <utility>

#include "import/mjcf/document.h"
#include "model/principal_moments.h"

namespace robcogen::import::from_mjcf {

namespace {

using model::SymmetricMatrix;

// Of moments that are computed, relative.
constexpr double kMomentRounding = 1e-12;

// About the centre of mass of the part, in its axes.
SymmetricMatrix tensor_of(const Part& part) {
  const double xy = part.xy.value(), xz = part.xz.value(), yz = part.yz.value();
  return {{{part.xx.value(), xy, xz}, {xy, part.yy.value(), yz}, {xz, yz, part.zz.value()}}};
}

// The principal moments of a body about its centre of mass, in ascending order.
std::array<double, 3> moments_of(const std::vector<Part>& parts) {
  if (parts.size() == 1) return model::principal_moments(tensor_of(parts.front()));
  std::vector<model::Inertia> all;
  for (const Part& part : parts) all.push_back(inertia_of(part, {}));
  const std::optional<model::Inertia> sum = model::sum_of(all);
  return sum ? model::principal_moments(model::central_tensor(*sum)) : std::array<double, 3>();
}

class PartReader {
 public:
  PartReader(const Name& body, const Context& context)
      : body_(body), context_(context), diagnostics_(context.diagnostics), values_(context.diagnostics) {}

  Part read_inertial(const Element& e) {
    Part part;
    require(e, "pos");
    part.pose = pose_of(e, context_.settings, diagnostics_);
    part.mass = values_.scalar(e, "mass");
    const Attribute* mass = require(e, "mass");
    part.mass_place = mass == nullptr ? e.place : mass->place;
    const Attribute* full = find(e, "fullinertia");
    const Attribute* diagonal = find(e, "diaginertia");
    part.inertia_place = full != nullptr ? full->place : diagonal != nullptr ? diagonal->place : e.place;
    if (full != nullptr && (diagonal != nullptr || has_orientation(e))) {
      diagnostics_.error(
          "two-inertias", full->place,
          fmt::format(
              "the inertial of body '{}' has both 'fullinertia' and {}", body_.text,
              diagonal != nullptr ? "'diaginertia'" : "an orientation"));
    } else if (full != nullptr) {
      const std::vector<Number> n = values_.numbers(*full, 6, 6);
      part.xx = n[0], part.yy = n[1], part.zz = n[2], part.xy = n[3], part.xz = n[4], part.yz = n[5];
    } else {
      part.has_given_axes = true;
      const auto n = values_.triple(e, "diaginertia", {});
      part.xx = n[0], part.yy = n[1], part.zz = n[2];
    }
    return part;
  }

  // MuJoCo raises the mass and the principal moments of a body to these bounds, even if it has no mass.
  void check_bounds(const std::vector<Part>& parts) {
    const double mass = context_.settings.least_mass.value(), moment = context_.settings.least_moment.value();
    if (mass <= 0.0 && moment <= 0.0) return;
    const auto reaches = [](double value, double bound) { return value >= bound * (1.0 - kMomentRounding); };
    double sum = 0.0;
    for (const Part& part : parts) sum += part.mass.value();
    if (reaches(sum, mass) && reaches(moments_of(parts)[0], moment)) return;
    diagnostics_
        .error(
            "below-bound", parts.empty() ? body_.place : parts.front().mass_place,
            fmt::format(
                "the mass or a moment of body '{}' is below 'boundmass' or 'boundinertia', which would raise it",
                body_.text))
        .hint = "write the values that are meant, and leave the bounds out";
  }

  void check_inertial(const Part& part) {
    if (part.mass.value() < 0.0)
      diagnostics_.error(
          "negative-mass", part.mass_place, fmt::format("the mass of body '{}' is negative", body_.text));
    if (part.xx.value() < 0.0 || part.yy.value() < 0.0 || part.zz.value() < 0.0)
      diagnostics_.error(
          "negative-moment", part.inertia_place,
          fmt::format("a moment of inertia of body '{}' is negative", body_.text));
    const bool is_diagonal = part.xy.is_zero() && part.xz.is_zero() && part.yz.is_zero();
    const auto [x, y, z] = moments_of({part});
    const double rounding = is_diagonal ? 0.0 : kMomentRounding * z;
    if (context_.settings.balances_inertias && x + y < z - rounding) {
      diagnostics_
          .error(
              "balanced-inertia", part.inertia_place,
              fmt::format(
                  "the moments of body '{}' are impossible: 'balanceinertia' would replace each by their mean",
                  body_.text))
          .hint = fmt::format("write diaginertia=\"{0} {0} {0}\" if that is meant", print_double((x + y + z) / 3.0));
    }
  }

 private:
  const Attribute* require(const Element& e, const char* attribute) {
    const Attribute* found = find(e, attribute);
    if (found == nullptr)
      diagnostics_.error(
          "missing-attribute", e.place,
          fmt::format("the inertial of body '{}' has no attribute '{}'", body_.text, attribute));
    return found;
  }

  const Name& body_;
  const Context& context_;
  Diagnostics& diagnostics_;
  Values values_;
};

}  // namespace

model::Inertia inertia_of(const Part& part, const Pose& body) {
  model::Inertia result;
  result.mass = quantity(part.mass);
  result.ixx = quantity(part.xx), result.iyy = quantity(part.yy), result.izz = quantity(part.zz);
  // The model stores products of inertia; the tensor contains their negatives.
  result.ixy = quantity(-part.xy), result.ixz = quantity(-part.xz), result.iyz = quantity(-part.yz);
  result.reference = placement_of(body * part.pose);
  return result;
}

std::vector<Part> read_parts(const Body& body, const Context& context) {
  PartReader reader(body.name, context);
  const std::size_t errors_before = context.diagnostics.error_count();
  std::vector<Part> parts;
  const InertiaFromGeoms from = context.settings.inertia_from_geoms;
  const bool counts_geoms = body.inertial ? from == InertiaFromGeoms::always : from != InertiaFromGeoms::never;
  for (const PlacedElement& geom : body.geoms) {
    std::optional<Part> part = counts_geoms ? read_geom(body.name, geom, context) : std::nullopt;
    if (part) parts.push_back(std::move(*part));
  }
  const bool takes_inertial = parts.empty() && body.inertial;
  if (takes_inertial) parts.push_back(reader.read_inertial(*body.inertial));
  // Values that are reported count as zeros, which say nothing about the bounds.
  const bool is_readable = context.diagnostics.error_count() == errors_before;
  if (takes_inertial) reader.check_inertial(parts.front());
  if (is_readable) reader.check_bounds(parts);
  return parts;
}

}  // namespace robcogen::import::from_mjcf
