// Converts elements to the document.
#include "import/urdf/read.h"

#include <fmt/format.h>

#include <filesystem>

namespace robcogen::import::from_urdf {
namespace {

// Returns the name of the file up to its first dot, without its folder; `robot` for a text that has no file.
std::string stem_of(const Source& source) {
  const std::string file = std::filesystem::path(source.name()).filename().string();
  const std::string stem = file.substr(0, file.find('.'));
  return stem.empty() || stem.starts_with('<') ? "robot" : stem;
}

// A robot without a name gets that of its file.
Name read_name(const Element& root, const Source& source, ElementReader& reader) {
  const Attribute* name = find(root, "name");
  if (name != nullptr && !name->value.empty()) return {name->value, reader.place(name->span)};
  const Place place = reader.place(name == nullptr ? root.span : name->span);
  const std::string stem = stem_of(source);
  reader.diagnostics().note("unnamed-robot", place, fmt::format("this 'robot' has no name: it is called '{}'", stem));
  return {stem, place};
}

// Versions 1.x differ in elements only, each of which is read or reported.
void check_version(const Element& root, ElementReader& reader) {
  const Attribute* version = find(root, "version");
  if (version == nullptr || version->value == "1" || version->value.starts_with("1.")) return;
  reader.diagnostics().warning(
      "unknown-version", reader.place(version->span),
      fmt::format("version '{}' of URDF is unknown: read as version 1", version->value));
}

}  // namespace

Document read_document(const Element& root, std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  if (root.name != "robot") {
    diagnostics.error(
        "other-format", {std::move(source), root.span},
        fmt::format("this XML is not a URDF: its root element is '{}', not 'robot'", root.name));
    return {};
  }
  Document document;
  document.source = source;
  ElementReader reader(std::move(source), diagnostics);
  document.name = read_name(root, *document.source, reader);
  check_version(root, reader);
  reader.check_attributes(root);
  for (const Element& child : root.children) {
    if (child.name == "link" || child.name == "joint" || child.name == "loop" || child.name == "coupling")
      reader.check_attributes(child);
    if (child.name == "link") {
      document.links.push_back(read_link(child, reader));
    } else if (child.name == "joint") {
      document.joints.push_back(read_joint(child, reader));
    } else if (child.name == "loop") {
      document.loops.push_back(read_loop(child, reader));
    } else if (child.name == "coupling") {
      document.couplings.push_back(read_coupling(child, reader));
    } else if (child.name != "transmission") {  // see read_transmissions
      reader.ignore(child, root, {"link", "joint"});
    }
  }
  if (document.links.empty())
    diagnostics.error("no-link", reader.place(root.span), fmt::format("robot '{}' has no link", document.name.text));
  reader.report_unread();
  document.ignored = reader.ignored();
  return document;
}

}  // namespace robcogen::import::from_urdf
