// Placeholders in the text of declarations.
#pragma once

#include <string>

#include "algorithm/catalogue/declaration.h"

namespace robcogen::algorithm::catalogue {

// Replaces `{A}` and `{B}` by the names of the left and the right frame, `{condition? text}` by the text if the subject
// meets the condition, and other names in braces by what phrases.cpp lists. Text of a condition may have placeholders.
std::string filled(const std::string& text, const Subject& subject);

}  // namespace robcogen::algorithm::catalogue
