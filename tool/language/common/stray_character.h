// Characters that belong to no token.
#pragma once

#include <string>
#include <string_view>

#include "support/diagnostics.h"

namespace robcogen::language {

struct StrayCharacter {
  std::string message;
  std::string hint;             // what to write instead; empty if unknown
  bool begins_comment = false;  // in another language: the rest of the line is not meant as text
};

// Returns what is wrong with the first character of a run of meaningless bytes.
StrayCharacter stray_character(std::string_view text, Span run);

}  // namespace robcogen::language
