#include "model/parametrise.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "model/about_origin.h"
#include "model/named_frame.h"
#include "support/index.h"
#include "support/wildcards.h"

namespace robcogen::model {
namespace {

const std::vector<std::string>& quantities() {
  static const std::vector<std::string> names = {"mass",        "com",       "inertia", "placement",
                                                 "translation", "rotation",  "damping", "friction",
                                                 "armature",    "stiffness", "rest",    "rotor"};
  return names;
}

class Parametrisation {
 public:
  Parametrisation(Description& description, Diagnostics& diagnostics)
      : description_(description), diagnostics_(diagnostics) {
    for (const Parameter& p : description.parameters) taken_.insert(p.name);
  }

  void add(const NamePattern& pattern) {
    const std::size_t dot = pattern.text.rfind('.');
    if (dot == std::string::npos || dot == 0) {
      diagnostics_
          .error("parameter-syntax", pattern.place, fmt::format("'{}' is not the quantity of an element", pattern.text))
          .hint = "write link.mass, link.inertia, frame.placement, joint.rotor, …";
      return;
    }
    element_ = pattern.text.substr(0, dot);
    quantity_ = pattern.text.substr(dot + 1);
    place_ = pattern.place;
    if (std::find(quantities().begin(), quantities().end(), quantity_) == quantities().end()) {
      Diagnostic& error = diagnostics_.error(
          "parameter-quantity", {place_.source, {place_.span.begin + dot + 1, place_.span.end}},
          fmt::format("'{}' is not a quantity that can be a parameter", quantity_));
      error.hint = did_you_mean(quantity_, quantities());
      if (error.hint.empty()) error.hint = fmt::format("those are {}", fmt::join(quantities(), ", "));
      return;
    }
    is_pattern_ = has_wildcards(element_);
    is_found_ = false;
    add_masses();
    add_placements();
    add_drives();
    if (!is_found_) report_unknown();
  }

 private:
  Description& description_;
  Diagnostics& diagnostics_;
  std::set<std::string> taken_;
  // Of the present pattern.
  std::string element_, quantity_;
  Place place_;
  bool is_pattern_ = false;
  bool is_found_ = false;

  bool is(const char* quantity) const { return quantity_ == quantity; }
  bool names(const std::string& element) const { return matches(element_, element); }

  template <class Visit>
  void for_each_link(const Visit& visit) {
    visit(description_.base);
    for (DescribedLink& link : description_.links) visit(link);
  }

  // Replaces a constant by a parameter.
  void make(Quantity& q, const std::string& name, ParameterKind kind, const Place& place) {
    is_found_ = true;
    if (!q.is_constant()) return;
    if (!taken_.insert(name).second) {
      diagnostics_.error("parameter-name", place_, fmt::format("the robot already has a parameter '{}'", name));
      return;
    }
    const auto index = static_cast<int>(description_.parameters.size());
    description_.parameters.push_back({name, kind, q.number().value(), place});
    q = Quantity::parameter(index);
  }

  void make(std::array<Quantity, 3>& q, const std::string& stem, ParameterKind kind, const Place& place) {
    static constexpr std::array kAxes = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) make(q[i], stem + kAxes[i], kind, place);
  }

  // ---- Mass properties.

  void add_masses() {
    if (!is("mass") && !is("com") && !is("inertia")) return;
    bool has_link = false;
    for_each_link([&](DescribedLink& link) {
      if (!names(link.name)) return;
      const bool moves = &link != &description_.base || description_.floating_base;
      if (is_pattern_ && (!moves || !link.inertia)) return;
      has_link = true;
      if (!moves) warn_unused(fmt::format("the mass of the fixed base '{}' has no effect", link.name), "");
      if (!link.inertia) {
        link.inertia.emplace();
        link.inertia_place = link.mass_place = link.place;
      }
      make_inertia(*link.inertia, link.name, link.inertia_place);
    });
    if (is_pattern_ || has_link || !is("inertia")) return;
    for_each_link([&](DescribedLink& link) {
      for (const DescribedFrame& frame : link.frames)
        if (names(frame.name)) add_body(link, frame);
    });
  }

  void make_inertia(Inertia& inertia, const std::string& name, const Place& place) {
    const auto kind = ParameterKind::inertial;
    if (!is("com")) make(inertia.mass, name + "_mass", kind, place);
    if (!is("mass")) make(inertia.com, name + "_com_", kind, place);
    if (!is("inertia")) return;
    make(inertia.ixx, name + "_ixx", kind, place);
    make(inertia.iyy, name + "_iyy", kind, place);
    make(inertia.izz, name + "_izz", kind, place);
    make(inertia.ixy, name + "_ixy", kind, place);
    make(inertia.ixz, name + "_ixz", kind, place);
    make(inertia.iyz, name + "_iyz", kind, place);
  }

  // Adds a body at a frame of the link.
  void add_body(DescribedLink& link, const DescribedFrame& frame) {
    Inertia body;
    make_inertia(body, frame.name, frame.place);
    body.reference = frame.placement;
    RigidBodyInertia sum = in_link_frame(body);
    if (link.inertia) {
      Inertia own = *link.inertia;
      for (const DescribedFrame& f : link.frames)
        if (link.reference_frame && f.name == *link.reference_frame) own.reference = f.placement;
      sum = in_link_frame(own) + sum;
    } else {
      link.inertia_place = link.mass_place = frame.place;
    }
    link.inertia = about_origin(sum);
    link.reference_frame.reset();
  }

  void warn_unused(const std::string& message, const std::string& hint) {
    diagnostics_.warning("parameter-unused", place_, message).hint = hint;
  }

  // ---- Placements.

  void add_placements() {
    if (!is("placement") && !is("translation") && !is("rotation")) return;
    for (DescribedJoint& joint : description_.joints)
      if (names(joint.name)) make_placement(joint.placement, joint.name, joint.place);
    for_each_link([&](DescribedLink& link) {
      for (DescribedFrame& frame : link.frames)
        if (names(frame.name) && !(is_pattern_ && frame.name == link.name))
          make_placement(frame.placement, frame.name, frame.place);
    });
  }

  void make_placement(Placement& placement, const std::string& name, const Place& place) {
    if (!is("rotation")) make(placement.translation, name + "_", ParameterKind::length, place);
    if (!is("translation")) make(placement.rotation, name + "_r", ParameterKind::angle, place);
  }

  // ---- Drives.

  void add_drives() {
    const bool is_passive = is("damping") || is("friction") || is("stiffness") || is("rest");
    if (is_passive && !description_.uses_passive_forces)
      warn_unused(
          fmt::format("the dynamics does not include the {} of joints", quantity_),
          "--passive-forces (PASSIVE_FORCES in CMake) includes damping and friction");
    add_tendons();
    for (DescribedJoint& joint : description_.joints) {
      if (!names_drive_of(joint)) continue;
      Drive& drive = joint.drive;
      const std::pair<const char*, Quantity*> fields[] = {
          {"damping", &drive.damping},
          {"friction", &drive.friction},
          {"armature", &drive.armature},
          {"stiffness", &drive.stiffness},
          {"rest", &drive.rest}};
      for (const auto& [name, value] : fields)
        if (is(name)) make(*value, joint.name + "_" + name, ParameterKind::inertial, joint.place);
      if (!is("rotor") || (is_pattern_ && !drive.rotor)) continue;
      if (!drive.rotor) {
        is_found_ = true;
        diagnostics_.error(
            "parameter-rotor", place_, fmt::format("joint '{}' of the document has no rotor", joint.name));
        continue;
      }
      make(drive.rotor->inertia, joint.name + "_rotor_inertia", ParameterKind::inertial, joint.place);
      make(drive.rotor->ratio, joint.name + "_rotor_ratio", ParameterKind::inertial, joint.place);
    }
  }

  // The inertia of the drive of an elastic joint is that of its motor.
  bool names_drive_of(const DescribedJoint& joint) const {
    if (!is("armature") && !is("rotor")) return names(joint.name);
    const auto is_motor = [&](const DescribedJoint& other) { return other.motor_of == joint.name; };
    if (std::any_of(description_.joints.begin(), description_.joints.end(), is_motor)) return false;
    return names(joint.name) || (!joint.motor_of.empty() && names(joint.motor_of));
  }

  void add_tendons() {
    for (DescribedTendon& tendon : description_.tendons) {
      if (!names(tendon.name)) continue;
      const std::pair<const char*, Quantity*> fields[] = {
          {"damping", &tendon.damping}, {"stiffness", &tendon.stiffness}, {"rest", &tendon.rest}};
      for (const auto& [name, value] : fields)
        if (is(name)) make(*value, tendon.name + "_" + name, ParameterKind::inertial, tendon.place);
    }
  }

  // ---- Messages.

  // The elements that have the present quantity.
  std::vector<std::string> candidates() {
    std::vector<std::string> result;
    const bool is_mass = is("mass") || is("com") || is("inertia");
    const bool is_of_frames = is("placement") || is("translation") || is("rotation");
    if (!is_mass) result = names_of(description_.joints);
    if (is("damping") || is("stiffness") || is("rest"))
      for (const DescribedTendon& tendon : description_.tendons) result.push_back(tendon.name);
    for_each_link([&](const DescribedLink& link) {
      if (is_mass) result.push_back(link.name);
      if (is_of_frames || is("inertia"))
        for (const DescribedFrame& frame : link.frames) result.push_back(frame.name);
    });
    return result;
  }

  void report_unknown() {
    const std::vector<std::string> known = candidates();
    Place place = place_;
    place.span.end = place.span.begin + element_.size();
    const bool is_mass = is("mass") || is("com") || is("inertia");
    const bool is_of_tendons = !description_.tendons.empty() && (is("damping") || is("stiffness") || is("rest"));
    const std::string kind = is_mass                                                  ? "link"
                             : is("placement") || is("translation") || is("rotation") ? "joint or frame"
                             : is_of_tendons                                          ? "joint or tendon"
                                                                                      : "joint";
    Diagnostic& error = diagnostics_.error(
        "parameter-element", place,
        is_pattern_
            ? fmt::format("no {} of robot '{}' with '{}' matches '{}'", kind, description_.name, quantity_, element_)
            : fmt::format("robot '{}' has no {} '{}'", description_.name, kind, element_));
    if (!is_pattern_) {
      error.hint = did_you_mean(element_, known);
    } else if (const std::string similar = nearest_to_pattern(element_, known); !similar.empty()) {
      error.hint = fmt::format("should it match '{}'?", similar);
    }
  }
};

}  // namespace

void add_parameters(Description& description, const std::vector<NamePattern>& patterns, Diagnostics& diagnostics) {
  Parametrisation parametrisation(description, diagnostics);
  for (const NamePattern& pattern : patterns) parametrisation.add(pattern);
}

}  // namespace robcogen::model
