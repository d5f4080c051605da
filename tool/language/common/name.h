// A name in a document, as written.
#pragma once

#include <string>

#include "support/source.h"

namespace robcogen::language {

struct Name {
  std::string text;  // without the escaping '^'
  Span span;
};

}  // namespace robcogen::language
