#include "import/mjcf/check.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/mjcf/defaults.h"
#include "import/mjcf/elements.h"
#include "import/xml/findings.h"

namespace robcogen::import::from_mjcf {

namespace {

class NameChecker {
 public:
  // `section` is the name of the element of the root that contains this one.
  void check(const Element& element, const std::string& section) {
    const std::string kind = kind_of(element, section);
    const KnownElement* known = known_element(kind);
    if (known == nullptr) return;
    for (const Attribute& a : element.attributes)
      if (!known->has(a.name)) add(kind, a, *known);
    const bool is_tree = kind == "worldbody" || kind == "body" || kind == "frame" || kind == "replicate";
    for (const Element& child : element.children) {
      const bool is_known =
          std::find(known->children.begin(), known->children.end(), child.name) != known->children.end();
      // The reader of the tree of bodies reports unknown elements in it.
      if (!is_known && !is_tree && kind != "geom") add(kind, child, *known);
      if (is_known || is_tree) check(child, section.empty() ? child.name : section);
    }
  }

  void report(Diagnostics& diagnostics) const { findings_.report(diagnostics); }

 private:
  xml::Findings findings_;

  // The name under which the table lists an element.
  static std::string kind_of(const Element& element, const std::string& section) {
    const std::string& name = element.name;
    if (section == "actuator") return name == "actuator" ? "actuators" : "actuator";
    if (section == "default" && is_actuator(name)) return "actuator";
    if (section == "default" && name == "equality") return "default/equality";
    if (section == "tendon") return name == "spatial" || name == "fixed" ? "tendon" : name == "tendon" ? "tendons" : "";
    if (section == "equality" && name != "equality") return "equality/" + name;
    if (section == "asset" && name != "asset" && name != "mesh") return "";
    // These generate bodies, and have attributes of their own.
    if (name == "composite" || name == "flexcomp") return "";
    return name;
  }

  void add(const std::string& kind, const Attribute& attribute, const KnownElement& known) {
    std::vector<std::string> names = known.read;
    names.insert(names.end(), known.without_effect.begin(), known.without_effect.end());
    const std::string owner = kind.substr(kind.rfind('/') + 1);
    findings_.add(
        kind + " " + attribute.name,
        {"unknown-attribute", fmt::format("attribute '{}' of this '{}' is unknown and ignored", attribute.name, owner),
         did_you_mean(attribute.name, names), attribute.name_place});
  }

  void add(const std::string& kind, const Element& child, const KnownElement& known) {
    if (child.name == "include") return;
    findings_.add(
        kind + "/" + child.name, {"unknown-element", fmt::format("element '{}' is unknown and ignored", child.name),
                                  did_you_mean(child.name, known.children), child.place});
  }
};

}  // namespace

void check_names(const Element& root, Diagnostics& diagnostics) {
  NameChecker checker;
  checker.check(root, "");
  checker.report(diagnostics);
}

}  // namespace robcogen::import::from_mjcf
