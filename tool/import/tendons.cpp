#include "import/tendons.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "import/coupling_sum.h"

namespace robcogen::import {
namespace {

namespace kinematics = language::kinematics;

// Reports terms of a length that are not all in rad or all in m.
void check_units(
    const kinematics::Tendon& tendon,
    const CouplingSum& length,
    const CoupledJoints& joints,
    const QuantityReader& reader,
    Diagnostics& diagnostics) {
  std::optional<Dimension> first;
  std::string first_joint;
  const auto name_of = [](const Dimension& d) { return d.m == 1 && d.rad == 0 ? "m" : "rad"; };
  for (const auto& [joint, term] : length.terms) {
    const std::optional<bool> turns = joints.turns(joint);
    if (!turns) continue;  // `build` reports it
    const Dimension unit = product(term.unit, unit_of(*turns), 1);
    const bool is_length = unit == unit_of(true) || unit == unit_of(false);
    if (is_length && (!first || *first == unit)) {
      if (!first) first = unit, first_joint = joint;
      continue;
    }
    if (!is_length)
      diagnostics.error(
          "tendon-units", reader.place(term.span),
          fmt::format(
              "the term of joint '{}' in the length of tendon '{}' is neither in rad nor in m", joint,
              tendon.name.text));
    else
      diagnostics
          .error(
              "tendon-units", reader.place(term.span),
              fmt::format(
                  "the length of tendon '{}' adds the term of joint '{}' in {} to that of joint '{}' in {}",
                  tendon.name.text, joint, name_of(unit), first_joint, name_of(*first)))
          .hint = fmt::format(
          "a factor with a unit converts it: write '0.05 m/rad * {}', for example", *turns ? joint : first_joint);
    return;
  }
  if (length.unit.is_said && first && length.unit != *first)
    diagnostics.error(
        "tendon-units", reader.place(*tendon.length),
        fmt::format("the constant in the length of tendon '{}' must be in {}", tendon.name.text, name_of(*first)));
}

}  // namespace

std::vector<model::DescribedTendon> read_tendons(
    const kinematics::Document& document,
    QuantityReader& reader,
    Diagnostics& diagnostics) {
  const CoupledJoints joints(document);
  std::vector<model::DescribedTendon> result;
  for (const kinematics::Tendon& tendon : document.tendons) {
    const std::optional<CouplingSum> length = read_length(*tendon.length, joints, reader, diagnostics);
    model::DescribedTendon described = {tendon.name.text, reader.place(tendon.name.span), {}, {}, {}, {}};
    const auto read = [&](const language::ExpressionPtr& e, model::Quantity& value, Place& place) {
      if (!e) return;
      value = reader.read(*e, model::ParameterKind::inertial);
      place = reader.place(*e);
    };
    Place rest_place;
    read(tendon.stiffness, described.stiffness, described.stiffness_place);
    read(tendon.damping, described.damping, described.damping_place);
    read(tendon.rest, described.rest, rest_place);
    if (!length) continue;
    check_units(tendon, *length, joints, reader, diagnostics);
    described.rest = described.rest - length->offset;
    for (const auto& [joint, term] : length->terms)
      described.terms.push_back({joint, term.factor, reader.place(term.span)});
    result.push_back(std::move(described));
  }
  return result;
}

}  // namespace robcogen::import
