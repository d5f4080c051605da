#include "model/tendons.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "model/plausibility.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

class Resolution {
 public:
  Resolution(const Description& description, NameIndex& joints, bool joints_repeat, Diagnostics& diagnostics)
      : description_(description), joints_(joints), joints_repeat_(joints_repeat), diagnostics_(diagnostics) {}

  std::vector<Tendon> run() {
    std::vector<Tendon> tendons;
    for (const DescribedTendon& described : description_.tendons) {
      const std::size_t errors_before = diagnostics_.error_count();
      check_name(described, tendons);
      check_sign("stiffness", described.stiffness, described.stiffness_place, described);
      check_sign("damping", described.damping, described.damping_place, described);
      Tendon tendon = {described.name,    terms_of(described), described.stiffness,
                       described.damping, described.rest,      described.place};
      const bool is_sound = diagnostics_.error_count() == errors_before;
      if (is_sound && tendon.terms.empty()) {
        if (!joints_repeat_)
          diagnostics_.error(
              "tendon-without-joint", described.place,
              fmt::format("the length of tendon '{}' depends on no joint", described.name));
        continue;
      }
      if (is_sound) tendons.push_back(std::move(tendon));
    }
    return tendons;
  }

 private:
  const Description& description_;
  NameIndex& joints_;
  bool joints_repeat_;
  Diagnostics& diagnostics_;

  void check_name(const DescribedTendon& described, const std::vector<Tendon>& tendons) {
    const auto same =
        std::find_if(tendons.begin(), tendons.end(), [&](const Tendon& other) { return other.name == described.name; });
    if (same == tendons.end()) return;
    diagnostics_
        .error("duplicate-tendon", described.place, fmt::format("tendon '{}' is declared twice", described.name))
        .notes.push_back({same->place, "first declared here"});
  }

  void check_sign(const char* what, const Quantity& quantity, const Place& place, const DescribedTendon& tendon) {
    const double value = value_at_defaults(quantity, description_.parameters).value_or(0.0);
    if (!(value < 0.0)) return;
    diagnostics_.error(
        "negative-drive", place.source ? place : tendon.place,
        fmt::format(
            "the {} of tendon '{}' is negative{}: {}", what, tendon.name,
            quantity.is_constant() ? "" : " by the default values of parameters", print_double(value)));
  }

  // The joints in the order of the robot, each once.
  std::vector<Tendon::Term> terms_of(const DescribedTendon& tendon) {
    std::map<int, Quantity> factors;
    for (const DescribedCoupling::Term& term : tendon.terms) {
      const std::optional<int> joint = find(term);
      if (!joint) continue;
      if (description_.joints[at(*joint)].type == JointType::spherical)
        diagnostics_.error(
            "tendon-spherical-joint", term.place,
            fmt::format(
                "the length of tendon '{}' cannot depend on spherical joint '{}': its position is not a single number",
                tendon.name, term.joint));
      factors[*joint] = factors[*joint] + term.factor;
    }
    std::vector<Tendon::Term> terms;
    for (auto& [joint, factor] : factors)
      if (!factor.is_zero()) terms.push_back({joint, std::move(factor)});
    return terms;
  }

  std::optional<int> find(const DescribedCoupling::Term& term) {
    if (const auto found = joints_.find(term.joint)) return found;
    if (joints_repeat_) return std::nullopt;
    Diagnostic& error =
        diagnostics_.error("unknown-joint", term.place, fmt::format("joint '{}' is not declared", term.joint));
    if (const auto similar = joints_.nearest_to(term.joint))
      error.hint = fmt::format("did you mean '{}'?", joints_.name_of(*similar));
    return std::nullopt;
  }
};

}  // namespace

std::vector<Tendon> resolve_tendons(
    const Description& description,
    NameIndex& joints,
    bool joints_repeat,
    Diagnostics& diagnostics) {
  return Resolution(description, joints, joints_repeat, diagnostics).run();
}

}  // namespace robcogen::model
