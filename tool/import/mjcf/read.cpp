// Converts elements to the document.
#include "import/mjcf/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace robcogen::import::from_mjcf {

namespace {

void ignore_section(const Element& section, Document& document, Diagnostics& diagnostics) {
  static const std::vector<std::string> kSilent = {"compiler", "option",    "size",   "visual",
                                                   "default",  "statistic", "custom", "asset"};
  if (std::find(kSilent.begin(), kSilent.end(), section.name) != kSilent.end()) return;
  static const std::vector<std::string> kKnown = {"contact",  "deformable", "tendon",   "actuator", "sensor",
                                                  "keyframe", "extension",  "equality", "worldbody"};
  if (std::find(kKnown.begin(), kKnown.end(), section.name) == kKnown.end()) {
    report_unknown(section, kKnown, diagnostics);
    return;
  }
  for (const Element& child : section.children) ++document.ignored[section.name + "/" + child.name];
}

// Warns once about forces of tendons.
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
      if (found == nullptr || is_off || !has_nonzero(*found, diagnostics)) continue;
      if (count++ == 0) first = found->place;
      break;
    }
  }
  if (count == 0) return;
  diagnostics.warning(
      "tendon-forces", first,
      fmt::format(
          "springs, damping, armature and friction of tendons are ignored, and the bodies move without them: {} "
          "tendon{}",
          count, count == 1 ? "" : "s"));
}

// Scales all masses to the total mass, in which bodies that do not move count too. Their masses are then removed.
void scale_masses(const Number& total, Document& document) {
  double sum = 0.0;
  for (const Body& body : document.bodies)
    for (const Part& part : body.parts) sum += part.mass.value();
  if (!(sum > 0.0)) return;
  const Number factor(total.value() / sum);
  std::vector<bool> moves;
  for (Body& body : document.bodies) {
    const bool is_carried = body.parent >= 0 && moves[static_cast<std::size_t>(body.parent)];
    moves.push_back(is_carried || body.floats || !body.joints.empty());
    if (!moves.back()) body.parts.clear();
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

Document read_document(const Element& root, const Options& options, Diagnostics& diagnostics) {
  const Settings settings = read_settings(root, diagnostics);
  const Defaults defaults(root, diagnostics);
  Document document;
  const Attribute* model = find(root, "model");
  document.name = model == nullptr ? Name{"robot", root.place} : Name{model->value, model->place};
  document.bodies.push_back({{"world", root.place}, -1, {}, false, {}, {}, {}, {}});
  for (const Element& section : root.children) {
    if (section.name == "worldbody") {
      read_bodies(section, settings, defaults, document, diagnostics);
    } else if (section.name == "equality") {
      read_equalities(section, settings, defaults, options, document, diagnostics);
    } else {
      if (section.name == "tendon") check_tendons(section, settings, defaults, diagnostics);
      ignore_section(section, document, diagnostics);
    }
  }
  if (settings.scales_masses()) scale_masses(settings.total_mass, document);
  std::erase_if(document.ignored, [](const auto& entry) { return entry.second == 0; });
  return document;
}

}  // namespace robcogen::import::from_mjcf
