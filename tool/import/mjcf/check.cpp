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
      {"body", {"name", "class", "childclass", "pos", "mocap", "gravcomp", "user", "sleep", "simple"}},
      {"frame", {"name", "childclass", "pos"}},
      {"freejoint", {"name", "group", "align"}},
      {"inertial", {"pos", "mass", "diaginertia", "fullinertia"}},
      {"site", {"name", "class", "type", "group", "pos", "material", "size", "fromto", "rgba", "user"}},
      {"geom", {"name",   "class",    "type",     "contype",    "conaffinity", "condim",       "group",  "priority",
                "size",   "material", "friction", "mass",       "density",     "shellinertia", "solmix", "solref",
                "solimp", "margin",   "gap",      "surfacevel", "adhesion",    "fromto",       "pos",    "hfield",
                "mesh",   "fitscale", "rgba",     "fluidshape", "fluidcoef",   "user"}},
      {"option",
       {"timestep",
        "apirate",
        "impratio",
        "tolerance",
        "ls_tolerance",
        "noslip_tolerance",
        "mpr_tolerance",
        "ccd_tolerance",
        "sleep_tolerance",
        "gravity",
        "wind",
        "magnetic",
        "density",
        "viscosity",
        "o_margin",
        "o_solref",
        "o_solimp",
        "o_friction",
        "integrator",
        "collision",
        "cone",
        "jacobian",
        "solver",
        "iterations",
        "ls_iterations",
        "noslip_iterations",
        "mpr_iterations",
        "ccd_iterations",
        "sdf_iterations",
        "sdf_initpoints",
        "actuatorgroupdisable"}},
      {"flag", {"constraint", "equality", "frictionloss", "limit",       "contact",      "passive",   "spring",
                "damper",     "gravity",  "clampctrl",    "warmstart",   "filterparent", "actuation", "refsafe",
                "sensor",     "midphase", "eulerdamp",    "autoreset",   "nativeccd",    "island",    "multiccd",
                "override",   "energy",   "fwdinv",       "invdiscrete", "sleep",        "diagexact", "sensornoise"}},
      {"equality", {"active", "solref", "solimp"}},  // in a default class
      {"equality/joint", {"name", "class", "active", "solref", "solimp", "joint1", "joint2", "polycoef"}},
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

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// `kind` names the known attributes.
void check(const Element& element, const std::string& kind, Diagnostics& diagnostics) {
  static const Names kTurning = {"body", "inertial", "frame", "site", "geom"};
  const auto known = known_attributes().find(kind);
  if (known == known_attributes().end()) return;
  for (const Attribute& a : element.attributes) {
    if ((is_orientation(a) && contains(kTurning, kind)) || contains(known->second, a.name)) continue;
    diagnostics
        .warning(
            "unknown-attribute", a.name_place,
            fmt::format("attribute '{}' of this '{}' is unknown and ignored", a.name, element.name))
        .hint = did_you_mean(a.name, known->second);
  }
}

void check_all(const Element& element, Diagnostics& diagnostics) {
  // Elements in these have attributes of their own.
  if (element.name == "composite" || element.name == "flexcomp") return;
  check(element, element.name, diagnostics);
  for (const Element& child : element.children) check_all(child, diagnostics);
}

}  // namespace

void check_attributes(const Element& root, Diagnostics& diagnostics) {
  static const Names kSections = {"compiler", "option", "default", "worldbody"};
  for (const Element& section : root.children) {
    if (contains(kSections, section.name)) check_all(section, diagnostics);
    if (section.name != "equality") continue;
    for (const Element& constraint : section.children)
      check(constraint, section.name + "/" + constraint.name, diagnostics);
  }
}

}  // namespace robcogen::import::from_mjcf
