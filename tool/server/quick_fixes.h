// Fixes that a diagnostic suggests, as changes of the text.
#pragma once

#include <string>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::server {

struct TextChange {
  Span span;
  std::string text;
};

struct QuickFix {
  std::string title;
  std::vector<TextChange> changes;  // in the text of the diagnostic
};

// Offers `did you mean 'x'?` and `write '^x'` as replacements, declarations of missing links and joints, missing items,
// and the corrections of text_fixes.h.
std::vector<QuickFix> quick_fixes(const Diagnostic& diagnostic);

}  // namespace robcogen::server
