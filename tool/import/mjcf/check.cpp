#include "import/mjcf/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace robcogen::import::from_mjcf {

namespace {

using Names = std::vector<std::string>;

// By element, in MJCF's own words.
const std::map<std::string, Names>& known_attributes() {
  static const std::map<std::string, Names> known = {
      {"compiler",
       {"angle",          "eulerseq",          "autolimits",       "boundmass", "boundinertia", "settotalmass",
        "balanceinertia", "strippath",         "coordinate",       "fitaabb",   "meshdir",      "texturedir",
        "assetdir",       "discardvisual",     "convexhull",       "usethread", "fusestatic",   "inertiafromgeom",
        "saveinertial",   "inertiagrouprange", "exactmeshinertia", "alignfree", "conflict"}},
      {"body", {"name", "class", "childclass", "pos", "mocap", "gravcomp", "user", "sleep"}},
      {"inertial", {"pos", "mass", "diaginertia", "fullinertia"}},
      {"joint",
       {"name",
        "class",
        "type",
        "group",
        "pos",
        "axis",
        "springdamper",
        "limited",
        "actuatorfrclimited",
        "actuatorgravcomp",
        "solreflimit",
        "solimplimit",
        "solreffriction",
        "solimpfriction",
        "stiffness",
        "range",
        "actuatorfrcrange",
        "margin",
        "ref",
        "springref",
        "armature",
        "damping",
        "frictionloss",
        "user"}}};
  return known;
}

void check(const Element& element, Diagnostics& diagnostics) {
  const auto known = known_attributes().find(element.name);
  if (known == known_attributes().end()) return;
  for (const Attribute& a : element.attributes) {
    const bool may_turn = element.name == "body" || element.name == "inertial";
    if ((may_turn && is_orientation(a)) || std::count(known->second.begin(), known->second.end(), a.name) > 0) continue;
    diagnostics
        .warning(
            "unknown-attribute", a.name_place,
            fmt::format("attribute '{}' of this '{}' is unknown and ignored", a.name, element.name))
        .hint = did_you_mean(a.name, known->second);
  }
}

void check_all(const Element& element, Diagnostics& diagnostics) {
  check(element, diagnostics);
  for (const Element& child : element.children) check_all(child, diagnostics);
}

}  // namespace

void check_attributes(const Element& root, Diagnostics& diagnostics) {
  for (const Element& section : root.children)
    if (section.name == "compiler" || section.name == "default" || section.name == "worldbody")
      check_all(section, diagnostics);
}

}  // namespace robcogen::import::from_mjcf
