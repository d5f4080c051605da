// XML as elements with places: what TinyXML reads, found again in the text.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::import::from_urdf {

struct Attribute {
  std::string name;
  std::string value;  // entities are resolved
  Span span;          // of the value, without its quotes
};

struct Element {
  std::string name;
  Span span;  // of `<name`
  std::vector<Attribute> attributes;
  std::vector<Element> children;  // in the order of the text; text between elements is left out
};

// Whether the tags of the text open and close one another, nest at most 100 deep and have at most 1000 attributes each,
// in at most 64 MiB: more than any robot needs, and no more than TinyXML, which recurses, can take. Reports what is
// wrong. Offsets are those of the text; a byte order mark must have been taken off.
bool check_tags(const std::shared_ptr<const Source>& source, std::string_view text, Diagnostics& diagnostics);

// The only element at the top of the document. Reports text that is no well-formed XML.
std::optional<Element> read_xml(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
