#include "import/couplings.h"

#include <fmt/format.h>

#include <utility>

#include "import/coupling_sum.h"

namespace robcogen::import {
namespace {

namespace kinematics = language::kinematics;

// Checks the unit of a factor: a factor between a joint that turns and one that slides must have a unit, and any other
// factor must not.
void check_unit(
    const kinematics::Coupling& coupling,
    const std::string& joint,
    const CouplingTerm& term,
    bool turns,
    bool joint_turns,
    const QuantityReader& reader,
    Diagnostics& diagnostics) {
  Dimension wanted = product(unit_of(turns), unit_of(joint_turns), -1);
  wanted.is_said = term.unit.is_said;
  if (term.unit == wanted && (term.unit.is_said || turns == joint_turns)) return;
  if (turns == joint_turns) {
    diagnostics.error(
        "coupling-units", reader.place(*coupling.value),
        fmt::format("the factor of joint '{}' must not have a unit: both joints {}", joint, turns ? "turn" : "slide"));
    return;
  }
  diagnostics
      .error(
          "coupling-units", reader.place(term.span),
          fmt::format(
              "joint '{}' {} and joint '{}' {}: the factor needs a unit", coupling.joint.text,
              turns ? "turns" : "slides", joint, joint_turns ? "turns" : "slides"))
      .hint = fmt::format("write '20.0 {} * {}', for example", turns ? "rad/m" : "m/rad", joint);
}

// Checks the units of a coupling, for joints that are declared.
void check_units(
    const kinematics::Coupling& coupling,
    const CouplingSum& sum,
    const CoupledJoints& joints,
    const QuantityReader& reader,
    Diagnostics& diagnostics) {
  const std::optional<bool> turns = joints.turns(coupling.joint.text);
  for (const auto& [joint, term] : sum.terms)
    if (const std::optional<bool> joint_turns = joints.turns(joint); turns && joint_turns)
      check_unit(coupling, joint, term, *turns, *joint_turns, reader, diagnostics);
  const Dimension own = unit_of(turns.value_or(true));
  if (!sum.unit.is_said || sum.unit == own) return;
  diagnostics.error(
      "coupling-units", reader.place(*coupling.value),
      fmt::format(
          "the constant of the coupling of joint '{}' must be in {}", coupling.joint.text, own.rad != 0 ? "rad" : "m"));
}

}  // namespace

std::vector<model::DescribedCoupling> read_couplings(
    const kinematics::Document& document,
    QuantityReader& reader,
    Diagnostics& diagnostics) {
  const CoupledJoints joints(document);
  std::vector<model::DescribedCoupling> result;
  for (const kinematics::Coupling& coupling : document.couplings) {
    const std::optional<CouplingSum> sum = read_coupling_sum(coupling, joints, reader, diagnostics);
    if (sum) check_units(coupling, *sum, joints, reader, diagnostics);
    if (!joints.is_single(coupling.joint.text)) continue;
    model::DescribedCoupling described = {coupling.joint.text, reader.place(coupling.joint.span), {}, {}};
    if (sum) {
      described.offset = sum->offset;
      for (const auto& [joint, term] : sum->terms)
        described.terms.push_back({joint, term.factor, reader.place(term.span)});
    }
    result.push_back(std::move(described));
  }
  return result;
}

}  // namespace robcogen::import
