#include "import/urdf/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/identifier.h"

namespace robcogen::import::from_urdf {

namespace {

constexpr std::size_t kMaxNameLength = 255;  // of a robot document

// The names in the document, by identifier.
using Taken = std::map<std::string, const Name*>;

void take(Taken& taken, const std::string& identifier, const Name& name, const char* kind, Diagnostics& diagnostics) {
  const auto [earlier, is_new] = taken.insert({identifier, &name});
  if (!is_new && earlier->second->text != name.text) {  // equal names were reported as declared twice
    diagnostics
        .error(
            "name-collision", name.place,
            fmt::format(
                "{0} '{1}' and {0} '{2}' both become '{3}'", kind, earlier->second->text, name.text, identifier))
        .notes.push_back({earlier->second->place, fmt::format("'{}' is declared here", earlier->second->text)});
  }
  if (identifier.size() > kMaxNameLength) {
    diagnostics.error(
        "name-too-long", name.place,
        fmt::format("the name of this {} has more than {} characters", kind, kMaxNameLength));
  }
}

// Returns `<name>_joint`, or `<name>_joint_2`, …: the first that is not the name of a link or of a joint.
std::string unused_name(const std::string& name, const Taken& links, const Document& document) {
  std::string result = name + "_joint";
  const auto is_used = [&] {
    return links.contains(result) || std::any_of(document.joints.begin(), document.joints.end(), [&](const Joint& j) {
             return has_axis(j) && identifier(j.name.text) == result;
           });
  };
  for (int k = 2; is_used(); ++k) result = fmt::format("{}_joint_{}", name, k);
  return result;
}

// Adds one note that lists names that are transliterated, because a text must use the new ones.
void mention_transliterated(const Document& document, const Identifiers& identifiers, Diagnostics& diagnostics) {
  constexpr std::size_t kShown = 4;
  std::vector<std::string> changes;
  Place first;
  const auto consider = [&](const char* kind, const Name& name, const std::string& identifier) {
    if (identifier.empty() || !is_beyond_ascii(name.text)) return;
    if (changes.empty()) first = name.place;
    changes.push_back(fmt::format("{} '{}' becomes '{}'", kind, name.text, identifier));
  };
  consider("robot", document.name, identifiers.robot);
  for (std::size_t l = 0; l < document.links.size(); ++l)
    consider("link", document.links[l].name, identifiers.links[l]);
  for (std::size_t j = 0; j < document.joints.size(); ++j)
    consider("joint", document.joints[j].name, identifiers.joints[j]);
  if (changes.empty()) return;
  const std::size_t more = changes.size() > kShown ? changes.size() - kShown : 0;
  changes.resize(changes.size() - more);
  diagnostics.note(
      "names-changed", first,
      fmt::format("{}{}", fmt::join(changes, ", "), more > 0 ? fmt::format(", and {} more", more) : ""));
}

}  // namespace

Identifiers identifiers_of(const Document& document, Diagnostics& diagnostics) {
  Identifiers result;
  Taken robots, links, joints;
  result.robot = identifier(document.name.text);
  take(robots, result.robot, document.name, "robot", diagnostics);
  for (const Link& link : document.links) {
    result.links.push_back(identifier(link.name.text));
    take(links, result.links.back(), link.name, "link", diagnostics);
  }
  for (const Joint& joint : document.joints) {
    std::string name = has_axis(joint) ? identifier(joint.name.text) : "";
    if (const auto link = links.find(name); link != links.end() && !name.empty()) {
      const std::string longer = unused_name(name, links, document);
      diagnostics
          .note(
              "joint-renamed", joint.name.place,
              fmt::format("joint '{}' becomes '{}': a link has the same name", joint.name.text, longer))
          .notes.push_back({link->second->place, "the link is declared here"});
      name = longer;
    }
    if (!name.empty()) take(joints, name, joint.name, "joint", diagnostics);
    result.joints.push_back(std::move(name));
  }
  mention_transliterated(document, result, diagnostics);
  return result;
}

}  // namespace robcogen::import::from_urdf
