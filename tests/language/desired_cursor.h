// A cursor on the text of a desired-transforms document, for tests of a single phase of its parser.
#pragma once

#include "language/desired/keywords.h"
#include "reading.h"

namespace robcogen::test {

struct DesiredText {
  explicit DesiredText(const std::string& text)
      : cursor(language::tokenize(source(text), diagnostics), language::desired::keywords(), diagnostics) {}

  Codes codes() const { return test::codes(diagnostics); }

  Diagnostics diagnostics;
  language::Cursor cursor;
};

}  // namespace robcogen::test
