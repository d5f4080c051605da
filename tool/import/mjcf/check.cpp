#include "import/mjcf/check.h"

#include "import/mjcf/defaults.h"
#include "import/mjcf/elements.h"
#include "import/xml/findings.h"
#include "support/words.h"

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
      if (!known->has_attribute(a.name))
        findings_.add(kind + " " + a.name, xml::unknown_attribute(a, kind.substr(kind.rfind('/') + 1), *known));
    const bool is_tree = kind == "worldbody" || kind == "body" || kind == "frame" || kind == "replicate";
    for (const Element& child : element.children) {
      const bool is_known = is_among(known->children, child.name);
      // The reader of the tree of bodies reports unknown elements in it.
      if (!is_known && !is_tree && kind != "geom" && child.name != "include")
        findings_.add(kind + "/" + child.name, xml::unknown_element(child, element.name, *known));
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
};

}  // namespace

void check_names(const Element& root, Diagnostics& diagnostics) {
  NameChecker checker;
  checker.check(root, "");
  checker.report(diagnostics);
}

}  // namespace robcogen::import::from_mjcf
