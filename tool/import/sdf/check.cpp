#include "import/sdf/check.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/sdf/elements.h"
#include "import/xml/findings.h"
#include "support/words.h"

namespace robcogen::import::from_sdf {
namespace {

constexpr const char* kNotRead = "mechanics-not-read";

std::string kind_of(const Element& element, const std::string& parent) {
  return known_element(parent + "/" + element.name) != nullptr ? parent + "/" + element.name : element.name;
}

// Elements of other programs have a prefix. Only Drake's describe mechanics.
bool is_custom(const std::string& name) {
  return name.find(':') != std::string::npos && !name.starts_with("drake:") && !name.starts_with("experimental:");
}

bool is_word(const Element& element, const std::vector<const char*>& words) {
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return element.text == word; });
}

bool is_nonzero(const Element& element) {
  const std::optional<Number> number = Number::parse(element.text);
  return !number || !number->is_zero();
}

// What a simulator does with an element of a link, which this generator does not; empty for other elements.
std::string meaning_of(const Element& element) {
  if (element.name == "gravity" && is_word(element, {"false", "False", "FALSE", "0"}))
    return "gravity acts on this link";
  if (element.name == "kinematic" && is_word(element, {"true", "True", "TRUE", "1"})) return "forces move this link";
  if (element.name == "velocity_decay" && std::any_of(element.children.begin(), element.children.end(), is_nonzero))
    return "its forces are not part of the dynamics";
  return "";
}

class NameChecker {
 public:
  void check(const Element& element, const std::string& parent) {
    const KnownElement* known = known_element(kind_of(element, parent));
    if (known == nullptr) return;
    for (const Attribute& a : element.attributes) check_attribute(element, a, *known);
    for (const Element& child : element.children) {
      if (element.name == "link") check_link(child);
      if (child.name == "plugin") check_plugin(child);
      if (is_among(known->children, child.name))
        check(child, element.name);
      else if (!is_among(known->children_without_effect, child.name) && !is_custom(child.name))
        findings_.add(element.name + "/" + child.name, xml::unknown_element(child, element.name, *known));
    }
  }

  void report(Diagnostics& diagnostics) const { findings_.report(diagnostics); }

 private:
  void check_attribute(const Element& element, const Attribute& a, const KnownElement& known) {
    if (known.has_attribute(a.name) || a.name.starts_with("xmlns") || is_custom(a.name)) return;
    findings_.add(element.name + " " + a.name, xml::unknown_attribute(a, element.name, known));
  }

  void check_link(const Element& child) {
    const std::string meaning = meaning_of(child);
    if (!meaning.empty())
      findings_.add(
          "link/" + child.name,
          {kNotRead, fmt::format("element '{}' of this 'link' is not read", child.name), meaning, child.place});
  }

  void check_plugin(const Element& plugin) {
    const auto value = [&](const char* name) {
      const Attribute* found = xml::find(plugin, name);
      return found == nullptr ? "" : found->value;
    };
    const std::string file = value("filename"), name = value("name");
    const PluginEffect effect = effect_of_plugin(file, name);
    if (effect == PluginEffect::none) return;
    const std::string label = name.empty() ? file : name;
    if (effect == PluginEffect::forces)
      findings_.add(
          "forces " + label, {kNotRead, fmt::format("plugin '{}' is not read", label),
                              "the robot moves without the forces that it adds", plugin.place});
    else
      findings_.add(
          "plugin " + label, {"unknown-plugin", fmt::format("plugin '{}' is unknown and ignored", label),
                              "forces that it adds are not part of the dynamics", plugin.place});
  }

  xml::Findings findings_;
};

}  // namespace

void check_names(const Element& root, Diagnostics& diagnostics) {
  NameChecker checker;
  checker.check(root, "");
  checker.report(diagnostics);
}

void count_ignored(const Element& element, std::map<std::string, int>& ignored) {
  const KnownElement* known = known_element(element.name);
  if (known == nullptr) return;
  for (const Element& child : element.children)
    if (is_among(known->children_without_effect, child.name) || is_custom(child.name)) ++ignored[child.name];
}

}  // namespace robcogen::import::from_sdf
