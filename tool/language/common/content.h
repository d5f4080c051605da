// What a file holds, whatever its name says.
#pragma once

#include <memory>
#include <string_view>

#include "language/common/lexer.h"

namespace robcogen::language {

// `unknown` is what may be a document of the four languages, or what is left of one.
enum class Content { unknown, urdf, sdf, mjcf, xml, json, yaml, binary };

// By the beginning of the text: the root element of XML, the first sign of JSON, the first key of YAML.
Content content_of(std::string_view text);

// Reports, once, content that nothing here reads: all but URDFs and unknown ones. Returns whether it did.
bool refuse_foreign(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

// The tokens of a document of the four languages. Other content, URDFs too, is reported once, and the list is cut.
TokenList tokenize_document(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

}  // namespace robcogen::language
