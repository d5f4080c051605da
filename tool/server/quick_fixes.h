// What a diagnostic proposes, as changes of the text.
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
  std::vector<TextChange> changes;  // of the text that the diagnostic is in
};

// `did you mean 'x'?` and `write '^x'` as replacements; declarations of missing links and joints; missing items; the
// corrections of text_fixes.h.
std::vector<QuickFix> quick_fixes(const Diagnostic& diagnostic);

}  // namespace robcogen::server
