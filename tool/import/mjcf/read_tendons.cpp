// Reads tendons, and what becomes of them: couplings, distances, and cylinders.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "import/mjcf/anchors.h"
#include "import/mjcf/read.h"

namespace robcogen::import::from_mjcf {

namespace {

// Reads the spring and the damper of a fixed tendon.
void read_force(const Element& e, Tendon& tendon, Diagnostics& diagnostics) {
  const auto read = [&](const char* attribute, Number& value, Place& place) {
    value = linear_coefficient(e, attribute, diagnostics);
    if (const Attribute* found = find(e, attribute)) place = found->place;
  };
  read("stiffness", tendon.stiffness, tendon.stiffness_place);
  read("damping", tendon.damping, tendon.damping_place);
  const Attribute* length = find(e, "springlength");
  if (length == nullptr || tendon.stiffness.is_zero()) return;
  const std::vector<Number> n = Values(diagnostics).numbers(*length, 1, 2);
  // -1 stands for the length where the joints are at their spring references.
  if (n.front().value() != -1.0) tendon.rest = n.front();
  if (n.size() == 1 || n[0] == n[1]) return;
  tendon.stiffness = Number();
  diagnostics
      .warning(
          "tendon-forces", length->place, "the spring of this tendon is ignored, because it is slack within a range")
      .hint = "write one number, the length at rest";
}

Tendon read_tendon(const Element& written, const Defaults& defaults, Diagnostics& diagnostics) {
  // A default `tendon` is that of tendons of all kinds.
  const Element e = defaults.resolved(written, nullptr, "tendon");
  Values values(diagnostics);
  Tendon tendon;
  const Attribute* name = find(e, "name");
  tendon.name = name == nullptr ? Name{"", e.place} : Name{name->value, name->place};
  if (e.name == "fixed") {
    tendon.kind = Tendon::Kind::fixed;
    for (const Element& child : e.children) {
      const Attribute* joint = child.name == "joint" ? find(child, "joint") : nullptr;
      if (joint != nullptr) tendon.terms.push_back({{joint->value, joint->place}, values.scalar(child, "coef")});
    }
    read_force(e, tendon, diagnostics);
  } else if (e.children.size() == 2) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Attribute* site = e.children[i].name == "site" ? find(e.children[i], "site") : nullptr;
      if (site == nullptr) return tendon;
      tendon.sites[i] = {site->value, site->place};
    }
    tendon.kind = Tendon::Kind::straight;
  }
  return tendon;
}

// The tendon that an attribute names, or nullptr. Reports an undeclared tendon.
Tendon* find_tendon(const Attribute& name, Document& document, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (Tendon& tendon : document.tendons) {
    if (tendon.name.text == name.value) return &tendon;
    names.push_back(tendon.name.text);
  }
  diagnostics.error("undeclared-end", name.place, fmt::format("tendon '{}' is not declared", name.value)).hint =
      did_you_mean(name.value, names);
  return nullptr;
}

double length_as_drawn(const Document& document, const std::array<Anchor, 2>& ends) {
  const Pose between = inverse(ends[0].pose) * drawn_pose(document, ends[0].body, ends[1].body) * ends[1].pose;
  double square = 0.0;
  for (const model::Quantity& q : between.translation) square += std::pow(model::evaluate(q), 2);
  return std::sqrt(square);
}

std::vector<std::array<Anchor, 2>> ends_of(const Tendon& tendon, const Document& document, Diagnostics& diagnostics) {
  return paired(
      document, anchors_at_sites(document, tendon.sites[0], diagnostics),
      anchors_at_sites(document, tendon.sites[1], diagnostics));
}

void mark_pulled(const Tendon& tendon, Document& document) {
  for (const Tendon::Term& term : tendon.terms)
    for (Body& body : document.bodies)
      for (Joint& joint : body.joints) joint.is_pulled = joint.is_pulled || is_named(joint, term.joint.text);
}

}  // namespace

void read_tendons(const Element& section, const Defaults& defaults, Document& document, Diagnostics& diagnostics) {
  for (const Element& e : section.children) {
    if (e.name != "fixed" && e.name != "spatial") continue;
    document.tendons.push_back(read_tendon(e, defaults, diagnostics));
    Tendon& tendon = document.tendons.back();
    if (!tendon.has_force()) continue;
    tendon.is_used = true;
    mark_pulled(tendon, document);
  }
}

// With the lengths L as drawn L0: L1 - L1_0 = a0 + a1 (L2 - L2_0) + ...
void read_tendon_equality(const Element& e, Document& document, Diagnostics& diagnostics) {
  const Attribute* given = find(e, "tendon1");
  if (given == nullptr) {
    diagnostics.error("missing-attribute", e.place, "this 'tendon' of 'equality' has no attribute 'tendon1'");
    return;
  }
  Tendon* tendon = find_tendon(*given, document, diagnostics);
  if (tendon == nullptr) return;
  Tendon* followed = nullptr;
  if (const Attribute* second = find(e, "tendon2")) {
    followed = find_tendon(*second, document, diagnostics);
    if (followed == nullptr) return;
  }
  std::vector<Number> a = {Number(), Number::rational(1), Number(), Number(), Number()};
  if (const Attribute* coefficients = find(e, "polycoef")) {
    const std::vector<Number> n = Values(diagnostics).numbers(*coefficients, 1, 5);
    std::copy(n.begin(), n.end(), a.begin());
  }
  const auto refuse = [&](const std::string& reason) { ignore_constraint(e, reason, diagnostics); };
  if (followed != nullptr && !(a[2].is_zero() && a[3].is_zero() && a[4].is_zero())) {
    refuse(fmt::format("'{}' is not a linear function of '{}'", tendon->name.text, followed->name.text));
  } else if (tendon->kind == Tendon::Kind::fixed && (followed == nullptr || followed->kind == Tendon::Kind::fixed)) {
    TendonCoupling coupling{{given->value, given->place}, tendon->terms, a[0]};
    tendon->is_used = true;
    if (followed != nullptr) {
      followed->is_used = true;
      for (const Tendon::Term& term : followed->terms) coupling.terms.push_back({term.joint, -a[1] * term.factor});
    }
    document.tendon_couplings.push_back(std::move(coupling));
  } else if (tendon->kind == Tendon::Kind::straight && followed == nullptr) {
    tendon->is_used = true;
    for (std::array<Anchor, 2>& ends : ends_of(*tendon, document, diagnostics)) {
      const Number length(length_as_drawn(document, ends) + a[0].value());
      const std::string name = tendon->name.text;
      add_loop(document, e, {name, e.place, model::LoopType::distance, std::move(ends), length}, diagnostics);
    }
  } else if (followed == nullptr) {
    refuse(fmt::format("tendon '{}' does not run straight between two sites", tendon->name.text));
  } else {
    refuse(fmt::format("'{}' and '{}' are not both fixed tendons", tendon->name.text, followed->name.text));
  }
}

bool pull_tendon(const Element& actuator, const Attribute& name, Document& document, Diagnostics& diagnostics) {
  Tendon* tendon = find_tendon(name, document, diagnostics);
  if (tendon == nullptr) return false;
  const auto mention = [&](const std::string& reason) {
    diagnostics.note(
        "tendon-actuator", actuator.place, fmt::format("this '{}' has no function: {}", actuator.name, reason));
  };
  if (tendon->kind == Tendon::Kind::fixed) {
    mark_pulled(*tendon, document);
    mention(fmt::format(
        "on each joint of the fixed tendon '{}', the force times its 'coef' is part of tau", tendon->name.text));
    return false;
  }
  if (tendon->kind == Tendon::Kind::winding) {
    mention(fmt::format("tendon '{}' does not run straight between two sites", tendon->name.text));
    return false;
  }
  const auto pulls = [&](const Cylinder& cylinder) { return cylinder.name.text == name.value; };
  if (std::any_of(document.cylinders.begin(), document.cylinders.end(), pulls)) return true;
  for (std::array<Anchor, 2>& ends : ends_of(*tendon, document, diagnostics)) {
    bool is_outside = false;
    const std::string fault = fault_of(document, ends, is_outside);
    if (!is_outside && !fault.empty()) mention(fault);
    if (!fault.empty()) continue;
    tendon->is_used = true;
    document.cylinders.push_back({{name.value, actuator.place}, std::move(ends)});
  }
  return tendon->is_used;
}

void count_unused_tendons(Document& document) {
  for (const Tendon& tendon : document.tendons)
    if (!tendon.is_used) ++document.ignored[tendon.kind == Tendon::Kind::fixed ? "tendon/fixed" : "tendon/spatial"];
}

}  // namespace robcogen::import::from_mjcf
