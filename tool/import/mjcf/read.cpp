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
      ignore_section(section, document, diagnostics);
    }
  }
  std::erase_if(document.ignored, [](const auto& entry) { return entry.second == 0; });
  return document;
}

}  // namespace robcogen::import::from_mjcf
