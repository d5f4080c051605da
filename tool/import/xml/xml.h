// XML as elements with places in the text.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::import::xml {

struct Attribute {
  std::string name;
  std::string value;  // entities are resolved
  Span span;          // of the value, without its quotes
};

struct Element {
  std::string name;
  Span span;  // of `<name`
  std::vector<Attribute> attributes;
  std::vector<Element> children;  // in the order of the text
  std::string text;               // the first text between its tags, without blanks at its ends
  Span text_span;
};

// Checks that the tags of the text match, are nested at most 100 levels deep, and have at most 1000 attributes each, in
// at most 64 MiB. This is more than any robot needs, and within what TinyXML, which recurses, can read. Reports the
// first fault. Offsets refer to the text, from which the byte order mark must have been removed.
bool check_tags(const std::shared_ptr<const Source>& source, std::string_view text, Diagnostics& diagnostics);

// Returns the root element. Reports text that is not well-formed XML.
std::optional<Element> read(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

}  // namespace robcogen::import::xml
