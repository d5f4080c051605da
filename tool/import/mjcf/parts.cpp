// Reads the masses of bodies.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/mjcf/document.h"

namespace robcogen::import::from_mjcf {

namespace {

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
      const auto n = values_.triple(e, "diaginertia", {});
      part.xx = n[0], part.yy = n[1], part.zz = n[2];
    }
    check(part);
    return part;
  }

  // MuJoCo raises masses and moments to these bounds.
  void check_bounds(const std::vector<Part>& parts) {
    const double mass = context_.settings.least_mass.value(), moment = context_.settings.least_moment.value();
    if (mass <= 0.0 && moment <= 0.0) return;
    for (const Part& part : parts) {
      if (part.mass.value() >= mass && std::min({part.xx.value(), part.yy.value(), part.zz.value()}) >= moment)
        continue;
      diagnostics_
          .error(
              "below-bound", part.mass_place,
              fmt::format(
                  "the mass or a moment of body '{}' is below 'boundmass' or 'boundinertia', which would raise it",
                  body_.text))
          .hint = "write the values that are meant, and leave the bounds out";
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

  void check(const Part& part) {
    if (part.mass.value() < 0.0)
      diagnostics_.error(
          "negative-mass", part.mass_place, fmt::format("the mass of body '{}' is negative", body_.text));
    if (part.xx.value() < 0.0 || part.yy.value() < 0.0 || part.zz.value() < 0.0)
      diagnostics_.error(
          "negative-moment", part.inertia_place,
          fmt::format("a moment of inertia of body '{}' is negative", body_.text));
    const bool is_diagonal = part.xy.is_zero() && part.xz.is_zero() && part.yz.is_zero();
    const double x = part.xx.value(), y = part.yy.value(), z = part.zz.value();
    if (context_.settings.balances_inertias && is_diagonal && (x + y < z || x + z < y || y + z < x)) {
      diagnostics_
          .error(
              "balanced-inertia", part.inertia_place,
              fmt::format(
                  "the moments of body '{}' are impossible: 'balanceinertia' would replace each by their mean",
                  body_.text))
          .hint = fmt::format("write diaginertia=\"{0} {0} {0}\" if that is meant", print_double((x + y + z) / 3.0));
    }
  }

  const Name& body_;
  const Context& context_;
  Diagnostics& diagnostics_;
  Values values_;
};

}  // namespace

std::vector<Part> read_parts(
    const Name& body,
    const Element* inertial,
    const std::vector<PlacedElement>& geoms,
    const Context& context) {
  PartReader reader(body, context);
  std::vector<Part> parts;
  const InertiaFromGeoms from = context.settings.inertia_from_geoms;
  const bool counts_geoms = inertial == nullptr ? from != InertiaFromGeoms::never : from == InertiaFromGeoms::always;
  for (const PlacedElement& geom : geoms) {
    std::optional<Part> part = counts_geoms ? read_geom(body, geom, context) : std::nullopt;
    if (part) parts.push_back(std::move(*part));
  }
  if (parts.empty() && inertial != nullptr) parts.push_back(reader.read_inertial(*inertial));
  reader.check_bounds(parts);
  return parts;
}

}  // namespace robcogen::import::from_mjcf
