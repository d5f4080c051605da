#include "import/mjcf/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "import/magnitudes.h"

namespace robcogen::import::from_mjcf {

namespace {

bool is_euler_sequence(const std::string& text) {
  return text.size() == 3 && text.find_first_not_of("xyzXYZ") == std::string::npos;
}

class SettingsReader {
 public:
  explicit SettingsReader(Diagnostics& diagnostics) : diagnostics_(diagnostics), values_(diagnostics) {}

  void read_compiler(const Element& e) {
    settings.degrees = values_.word(e, "angle", {"radian", "degree"}, settings.degrees ? 1 : 0) == 1;
    if (const Attribute* sequence = find(e, "eulerseq")) read_sequence(*sequence);
    constexpr std::array kChoices = {InertiaFromGeoms::never, InertiaFromGeoms::always, InertiaFromGeoms::where_absent};
    settings.inertia_from_geoms = kChoices[values_.word(
        e, "inertiafromgeom", {"false", "true", "auto"}, static_cast<std::size_t>(settings.inertia_from_geoms))];
    settings.limits_follow_ranges = flag(e, "autolimits", settings.limits_follow_ranges);
    settings.balances_inertias = flag(e, "balanceinertia", settings.balances_inertias);
    settings.least_mass = values_.scalar(e, "boundmass", settings.least_mass);
    settings.least_moment = values_.scalar(e, "boundinertia", settings.least_moment);
    if (const Attribute* range = find(e, "inertiagrouprange")) read_groups(*range);
    if (values_.word(e, "coordinate", {"local", "global"}, 0) == 1)
      refuse(*find(e, "coordinate"), "global coordinates are not supported").hint =
          "versions of MuJoCo that read global coordinates save the model with local ones";
    settings.total_mass = values_.scalar(e, "settotalmass", settings.total_mass);
    settings.aligns_free_bodies = flag(e, "alignfree", settings.aligns_free_bodies);
    if (const Attribute* alignment = find(e, "alignfree")) settings.alignment_place = alignment->place;
    for (const char* name : {"assetdir", "meshdir"})
      if (const Attribute* folder = find(e, name)) settings.mesh_folder = folder->value;
    settings.strips_paths = flag(e, "strippath", settings.strips_paths);
    settings.has_exact_meshes = flag(e, "exactmeshinertia", settings.has_exact_meshes);
  }

  void read_option(const Element& e) {
    const Attribute* gravity = find(e, "gravity");
    const auto g = values_.triple(e, "gravity", {Number(), Number(), Number(-9.81)});
    if (gravity != nullptr && (!g[0].is_zero() || !g[1].is_zero() || g[2].value() != -9.81)) {
      diagnostics_.note(
          "other-gravity", gravity->place,
          fmt::format(
              "the gravity of this file is ({}, {}, {}); functions use (0, 0, -9.81) unless they are given another",
              print_double(g[0].value()), print_double(g[1].value()), print_double(g[2].value())));
    }
    for (const Element& flags : e.children)
      if (flags.name == "flag") check_flags(flags);
    const auto wind = values_.triple(e, "wind", {});
    const bool has_wind = std::any_of(wind.begin(), wind.end(), [](const Number& n) { return !n.is_zero(); });
    if (values_.scalar(e, "density").is_zero() && values_.scalar(e, "viscosity").is_zero() && !has_wind) return;
    diagnostics_.warning("medium-ignored", e.place, "the forces of a medium (density, viscosity, wind) are ignored");
  }

  Settings settings;

 private:
  bool flag(const Element& e, const char* attribute, bool otherwise) {
    return values_.word(e, attribute, {"false", "true"}, otherwise ? 1 : 0) == 1;
  }

  void read_groups(const Attribute& range) {
    const std::optional<std::vector<Number>> groups = values_.read(range, 2, 2);
    if (!groups) return;
    settings.first_group = (*groups)[0];
    settings.last_group = (*groups)[1];
  }

  void check_flags(const Element& flags) {
    const auto enabled = [&](const char* what, bool otherwise) {
      return values_.word(flags, what, {"disable", "enable"}, otherwise ? 1 : 0) == 1;
    };
    settings.constraints = enabled("constraint", settings.constraints);
    settings.equalities = enabled("equality", settings.equalities);
    settings.friction = enabled("frictionloss", settings.friction);
    for (const char* what : {"gravity", "passive", "spring", "damper"}) {
      if (enabled(what, true)) continue;
      diagnostics_.warning(
          "flag-ignored", find(flags, what)->place,
          fmt::format("the flag that disables '{}' in MuJoCo is ignored", what));
    }
  }

  Diagnostic& refuse(const Attribute& attribute, const std::string& message) {
    return diagnostics_.error("unsupported-compiler", attribute.place, message);
  }

  void read_sequence(const Attribute& sequence) {
    if (is_euler_sequence(sequence.value)) {
      settings.euler_sequence = sequence.value;
      return;
    }
    diagnostics_.error(
        "unknown-word", sequence.place,
        fmt::format("'{}' is not a sequence of axes: three letters of xyzXYZ", sequence.value));
  }

  Diagnostics& diagnostics_;
  Values values_;
};

}  // namespace

void Settings::check_angle(const Number& written, double turns, const Place& place, Diagnostics& diagnostics) const {
  const std::string message = degrees ? "" : large_angle(written.value(), turns);
  if (message.empty()) return;
  diagnostics.warning("large-angle", place, message).hint =
      "angle=\"radian\" of 'compiler' applies to all angles; without it, they are in degrees";
}

Settings read_settings(const Element& root, Diagnostics& diagnostics) {
  SettingsReader reader(diagnostics);
  for (const Element& section : root.children) {
    if (section.name == "compiler") reader.read_compiler(section);
    if (section.name == "option") reader.read_option(section);
  }
  return reader.settings;
}

}  // namespace robcogen::import::from_mjcf
