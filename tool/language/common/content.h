// Detects the kind of document in a file from its text.
#pragma once

#include <memory>
#include <string_view>

#include "language/common/lexer.h"

namespace robcogen::language {

// `unknown`: possibly a document in one of the four languages, or a part of one.
enum class Content { unknown, urdf, sdf, mjcf, xml, json, yaml, binary };

// Detects the content by the beginning of the text: the root element of XML, the first character of JSON, the first key
// of YAML.
Content content_of(std::string_view text);

// Reports, once, content that robcogen does not read: all kinds except `urdf` and `unknown`. Returns whether it
// reported anything.
bool refuse_foreign(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

// Returns the tokens of a document in one of the four languages. Other content, including URDF, is reported once, and
// the list is cut.
TokenList tokenize_document(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

}  // namespace robcogen::language
