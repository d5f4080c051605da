// Reads the joints of bodies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "import/magnitudes.h"
#include "import/mjcf/document.h"

namespace robcogen::import::from_mjcf {

namespace {

class JointReader {
 public:
  JointReader(const Element& element, const Settings& settings, Diagnostics& diagnostics)
      : element_(element), settings_(settings), diagnostics_(diagnostics), values_(diagnostics) {}

  std::optional<Joint> read() {
    const std::size_t type = values_.word(element_, "type", {"hinge", "slide", "ball", "free"}, 0);
    const Attribute* name = find(element_, "name");
    joint_.name = name == nullptr ? Name{"", element_.place} : Name{name->value, name->place};
    if (type == 3) {
      diagnostics_
          .error(
              "free-joint-inside", find(element_, "type")->place,
              "a free joint must be the only joint of a body whose parent is the world")
          .hint = "a free-floating body is a separate robot: write it to a separate file";
      return std::nullopt;
    }
    joint_.pos = values_.triple(element_, "pos", {});
    if (type == 2) {
      read_ball();
      return joint_;
    }
    is_hinge_ = type == 0;
    joint_.type = is_hinge_ ? model::JointType::revolute : model::JointType::prismatic;
    read_axis();
    joint_.reference = position("ref");
    joint_.spring_reference = position("springref");
    read_drive();
    read_limits();
    return joint_;
  }

 private:
  // A ball joint turns about any axis: `axis` and `ref` have no meaning. The model refuses friction and springs that
  // have a place; zero values lose it, because they count as absent.
  void read_ball() {
    joint_.type = model::JointType::spherical;
    joint_.axis = {Number(), Number(), Number::rational(1)};
    read_drive();
    if (joint_.drive.friction.is_zero()) joint_.places.friction = {};
    if (joint_.drive.stiffness.is_zero()) joint_.places.stiffness = {};
    for (const auto& [name, limited] :
         {std::pair("range", "limited"), std::pair("actuatorfrcrange", "actuatorfrclimited")}) {
      if (!read_range(name, limited)) continue;
      diagnostics_.warning(
          "ball-limits", find(element_, name)->place,
          fmt::format("the '{}' of a ball joint is left out: spherical joints do not have it", name));
    }
  }

  // Converts a position from the unit of the compiler if the joint is a hinge.
  Number in_si_units(const Number& written, const Place& place) {
    if (!is_hinge_) return written;
    if (std::abs(written.value()) < model::kNoLimit) settings_.check_angle(written, kTurnsOfJoint, place, diagnostics_);
    return settings_.angle(written);
  }

  Number position(const char* attribute) {
    const Attribute* found = find(element_, attribute);
    return found == nullptr ? Number() : in_si_units(values_.scalar(element_, attribute), found->place);
  }

  void read_axis() {
    joint_.axis = values_.triple(element_, "axis", {Number(), Number(), Number::rational(1)});
    const auto is_zero = [](const Number& n) { return n.is_zero(); };
    if (std::all_of(joint_.axis.begin(), joint_.axis.end(), is_zero))
      diagnostics_.error("no-direction", find(element_, "axis")->place, "this 'axis' gives no direction");
  }

  void read_value(const char* attribute, model::Quantity& value, Place& place) {
    value = quantity(values_.scalar(element_, attribute));
    if (const Attribute* found = find(element_, attribute)) place = found->place;
  }

  void read_coefficient(const char* attribute, model::Quantity& value, Place& place) {
    value = quantity(linear_coefficient(element_, attribute, diagnostics_));
    if (const Attribute* found = find(element_, attribute)) place = found->place;
  }

  void read_drive() {
    read_coefficient("damping", joint_.drive.damping, joint_.places.damping);
    if (settings_.has_friction()) read_value("frictionloss", joint_.drive.friction, joint_.places.friction);
    read_value("armature", joint_.drive.armature, joint_.places.armature);
    read_coefficient("stiffness", joint_.drive.stiffness, joint_.places.stiffness);
    if (!joint_.drive.stiffness.is_zero() || find(element_, "springdamper") != nullptr)
      joint_.drive.rest = quantity(joint_.spring_reference);
    if (const Attribute* rest = find(element_, "springref")) joint_.places.rest = rest->place;
    const Attribute* damper = find(element_, "springdamper");
    if (damper == nullptr) return;
    const std::vector<Number> both = values_.numbers(*damper, 2, 2);
    if (both[0].is_zero() && both[1].is_zero()) return;
    joint_.spring_damper = SpringDamper{both[0], both[1], damper->place};
    if (both[0].value() > 0.0 && both[1].value() > 0.0) return;
    diagnostics_.error("spring-damper", damper->place, "both numbers of 'springdamper' must be positive");
  }

  static const std::vector<std::string>& limit_words() {
    static const std::vector<std::string> words = {"false", "true", "auto"};
    return words;
  }

  // Whether the attribute `limited`, or the mere presence of a range, enables these limits.
  bool is_limited(const char* limited, const Attribute& range) {
    const std::size_t choice = values_.word(element_, limited, limit_words(), 2);
    if (choice != 2) return choice == 1;
    if (settings_.limits_follow_ranges) return true;
    diagnostics_
        .warning(
            "limits-unclear", range.place,
            fmt::format("this '{}' does not limit the joint: '{}' is not \"true\"", range.name, limited))
        .hint = "leave autolimits=\"false\" out, or write limited=\"true\"";
    return false;
  }

  // Reads the limits if they are enabled. A range of two zeros counts as absent.
  std::optional<std::array<Number, 2>> read_range(const char* name, const char* limited) {
    const Attribute* range = find(element_, name);
    if (range != nullptr) {
      const std::optional<std::vector<Number>> n = values_.read(*range, 2, 2);
      if (!n) return std::nullopt;
      if (!(*n)[0].is_zero() || !(*n)[1].is_zero())
        return is_limited(limited, *range) ? std::optional(std::array{(*n)[0], (*n)[1]}) : std::nullopt;
    }
    if (values_.word(element_, limited, limit_words(), 2) == 1)
      diagnostics_
          .error(
              "limit-without-range", joint_.name.place,
              fmt::format("this joint has no '{}', but '{}' is \"true\"", name, limited))
          .hint = fmt::format("write {}=\"...\", or {}=\"false\"", name, limited);
    return std::nullopt;
  }

  void read_limits() {
    if (const auto range = read_range("range", "limited")) {
      const Place place = find(element_, "range")->place;
      joint_.limits.lower = in_si_units((*range)[0], place).value();
      joint_.limits.upper = in_si_units((*range)[1], place).value();
      joint_.places.position_limits = place;
    }
    if (const auto range = read_range("actuatorfrcrange", "actuatorfrclimited")) {
      const double least = (*range)[0].value(), most = (*range)[1].value();
      joint_.limits.effort = std::max(std::abs(least), std::abs(most));
      joint_.places.effort_limit = find(element_, "actuatorfrcrange")->place;
      if (-least != most)
        diagnostics_.note(
            "one-effort-limit", joint_.places.effort_limit,
            fmt::format(
                "the effort of this joint is limited to {} in both directions, not from {} to {}",
                print_double(joint_.limits.effort), print_double(least), print_double(most)));
    }
  }

  const Element& element_;
  const Settings& settings_;
  Diagnostics& diagnostics_;
  Values values_;
  Joint joint_;
  bool is_hinge_ = true;
};

}  // namespace

std::optional<Joint> read_joint(const Element& element, const Settings& settings, Diagnostics& diagnostics) {
  return JointReader(element, settings, diagnostics).read();
}

}  // namespace robcogen::import::from_mjcf
