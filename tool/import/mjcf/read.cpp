// Converts elements to the document.
#include "import/mjcf/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/mjcf/shapes.h"

namespace robcogen::import::from_mjcf {

namespace {

void ignore_section(const Element& section, Document& document) {
  static const std::vector<std::string> kCounted = {"contact",  "deformable", "tendon",  "sensor",
                                                    "keyframe", "extension",  "equality"};
  if (std::find(kCounted.begin(), kCounted.end(), section.name) == kCounted.end()) return;
  for (const Element& child : section.children)
    if (section.name != "tendon" || (child.name != "fixed" && child.name != "spatial"))
      ++document.ignored[section.name + "/" + child.name];
}

// Warns once about forces of tendons that are not read.
void check_tendons(
    const Element& section,
    const Settings& settings,
    const Defaults& defaults,
    Diagnostics& diagnostics) {
  int count = 0;
  Place first;
  for (const Element& given : section.children) {
    // A default `tendon` is that of tendons of all kinds.
    const Element tendon = defaults.resolved(given, nullptr, "tendon");
    for (const char* name : {"stiffness", "damping", "armature", "frictionloss"}) {
      const Attribute* found = find(tendon, name);
      const bool is_off = std::string(name) == "frictionloss" && !settings.has_friction();
      const bool is_read =
          given.name == "fixed" && (std::string(name) == "stiffness" || std::string(name) == "damping");
      if (found == nullptr || is_off || is_read || !has_nonzero(*found, diagnostics)) continue;
      if (count++ == 0) first = found->place;
      break;
    }
  }
  if (count == 0) return;
  diagnostics.warning(
      "tendon-forces", first,
      fmt::format(
          "armature and friction of tendons, and springs and damping of those that are not fixed, are ignored, and "
          "the bodies move without them: {} tendon{}",
          count, count == 1 ? "" : "s"));
}

// Scales all masses to the total mass, in which bodies that do not move count too. Their masses are then removed.
void scale_masses(const Number& total, Document& document) {
  double sum = 0.0;
  for (const Body& body : document.bodies)
    for (const Part& part : body.parts) sum += part.mass.value();
  if (!(sum > 0.0)) return;
  const Number factor(total.value() / sum);
  for (Body& body : document.bodies) {
    if (!body.moves) body.parts.clear();
    for (Part& part : body.parts)
      for (Number* n : {&part.mass, &part.xx, &part.yy, &part.zz, &part.xy, &part.xz, &part.yz}) *n = *n * factor;
  }
}

}  // namespace

void report_unknown(const Element& element, const std::vector<std::string>& known, Diagnostics& diagnostics) {
  diagnostics
      .warning("unknown-element", element.place, fmt::format("element '{}' is unknown and ignored", element.name))
      .hint = did_you_mean(element.name, known);
}

void read_masses(Document& document, const Context& context) {
  for (std::size_t b = 0; b < document.bodies.size(); ++b) {
    Body& body = document.bodies[b];
    const bool is_needed = body.moves && document.robot.has[b];
    if (is_needed || (context.settings.scales_masses() && b > 0)) body.parts = read_parts(body, context);
    const bool has_mass_of_geoms = !body.inertial || context.settings.inertia_from_geoms == InertiaFromGeoms::always;
    const std::size_t used = has_mass_of_geoms ? body.parts.size() : 0;
    document.ignored["geom"] += static_cast<int>(body.geoms.size() - std::min(used, body.geoms.size()));
  }
  if (context.settings.scales_masses()) scale_masses(context.settings.total_mass, document);
}

Document read_document(
    const Element& root,
    const std::filesystem::path& file,
    const MjcfOptions& options,
    std::vector<std::filesystem::path>& read,
    Diagnostics& diagnostics) {
  const Settings settings = read_settings(root, diagnostics);
  const Defaults defaults(root, diagnostics);
  Document document;
  const Attribute* model = find(root, "model");
  document.name = model == nullptr ? Name{"robot", root.place} : Name{model->value, model->place};
  document.bodies.emplace_back().name = {"world", root.place};
  for (const Element& section : root.children)
    if (section.name == "worldbody") read_bodies(section, settings, defaults, document, diagnostics);
  const std::size_t errors_before = diagnostics.error_count();
  document.robot = choose_robot(document, options.robot, diagnostics);
  if (diagnostics.error_count() > errors_before) return document;  // what follows depends on the choice
  Meshes meshes(root, settings, defaults, file.parent_path(), read, diagnostics);
  const Context context = {settings, defaults, diagnostics, meshes};
  read_masses(document, context);
  read_shapes(document, options.shapes, context);
  align_free_body(document, settings, diagnostics);
  for (const Element& section : root.children)
    if (section.name == "tendon") read_tendons(section, defaults, document, diagnostics);
  for (const Element& section : root.children) {
    if (section.name == "equality") {
      read_equalities(section, settings, defaults, options, document, diagnostics);
    } else if (section.name == "actuator") {
      read_actuators(section, defaults, document, diagnostics);
    } else if (section.name != "worldbody") {
      if (section.name == "tendon") check_tendons(section, settings, defaults, diagnostics);
      if (section.name == "contact" && options.shapes.are_checked)
        read_excludes(section, document, diagnostics);
      else
        ignore_section(section, document);
    }
  }
  count_unused_tendons(document);
  resolve_spring_dampers(document, diagnostics);
  if (!document.loops.empty()) {
    for (const Element& section : root.children)
      if (section.name == "keyframe" && !document.has_key) document.has_key = read_key(section, document, diagnostics);
    if (document.has_key) --document.ignored["keyframe/key"];
    split_ball_joints(document, diagnostics);
  }
  std::erase_if(document.ignored, [](const auto& entry) { return entry.second == 0; });
  return document;
}

}  // namespace robcogen::import::from_mjcf
