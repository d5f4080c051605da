// Converts elements to the document.
#include "import/urdf/read.h"

#include <fmt/format.h>

namespace robcogen::import::from_urdf {

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
  document.name = reader.name(root, "name");
  if (const Attribute* version = find(root, "version")) document.version = version->value;
  for (const Element& child : root.children) {
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
  document.ignored = reader.ignored();
  return document;
}

}  // namespace robcogen::import::from_urdf
