// Reads constraints between joints, and finds those of other kinds.
#include <fmt/format.h>

#include <utility>

#include "import/mjcf/read.h"

namespace robcogen::import::from_mjcf {

namespace {

// Reads a linear constraint between two joints or on one joint.
void read_coupling(const Element& e, const Attribute& joint, Document& document, Diagnostics& diagnostics) {
  Coupling coupling{{joint.value, joint.place}, {"", joint.place}, Number(), Number::rational(1)};
  if (const Attribute* followed = find(e, "joint2")) coupling.followed = {followed->value, followed->place};
  if (const Attribute* given = find(e, "polycoef")) {
    // Coefficients that are left out keep their defaults.
    const std::vector<Number> kDefaults = {Number(), Number::rational(1), Number(), Number(), Number()};
    std::vector<Number> a = Values(diagnostics).numbers(*given, 1, 5);
    a.insert(a.end(), kDefaults.begin() + static_cast<std::ptrdiff_t>(a.size()), kDefaults.end());
    coupling.offset = a[0];
    coupling.factor = a[1];
    const bool is_linear = a[2].is_zero() && a[3].is_zero() && a[4].is_zero();
    if (!is_linear && !coupling.followed.text.empty()) {
      diagnostics
          .error(
              "coupled-joint", given->place,
              fmt::format("joint '{}' is not a linear function of joint '{}'", joint.value, coupling.followed.text))
          .hint = "--free-mimic-joints makes it an independent joint";
      return;
    }
  }
  document.couplings.push_back(std::move(coupling));
}

void read_other(const Element& e, const MjcfOptions& options, Document& document, Diagnostics& diagnostics) {
  const bool is_loop = e.name == "connect" || e.name == "weld";
  if (!is_loop && e.name != "tendon") {
    ++document.ignored["equality/" + e.name];
  } else if (options.free_equality_joints) {
    diagnostics.note("constraint-left-out", e.place, fmt::format("this '{}' of 'equality' is ignored", e.name));
  } else if (is_loop) {
    read_loop(e, document, diagnostics);
  } else {
    read_tendon_equality(e, document, diagnostics);
  }
}

}  // namespace

void read_equalities(
    const Element& section,
    const Settings& settings,
    const Defaults& defaults,
    const MjcfOptions& options,
    Document& document,
    Diagnostics& diagnostics) {
  if (!settings.has_equalities()) return;
  for (const Element& given : section.children) {
    // A default `equality` is that of constraints of all kinds.
    const Element e = defaults.resolved(given, nullptr, "equality");
    if (Values(diagnostics).word(e, "active", {"false", "true"}, 1) == 0) continue;
    if (e.name != "joint") {
      read_other(e, options, document, diagnostics);
      continue;
    }
    const Attribute* joint = find(e, "joint1");
    if (joint == nullptr) {
      diagnostics.error("missing-attribute", e.place, "this 'joint' of 'equality' has no attribute 'joint1'");
    } else if (options.free_equality_joints) {
      diagnostics.note(
          "free-joint-kept", joint->place,
          fmt::format("joint '{}' is independent: its 'equality' is ignored", joint->value));
    } else {
      read_coupling(e, *joint, document, diagnostics);
    }
  }
}

}  // namespace robcogen::import::from_mjcf
