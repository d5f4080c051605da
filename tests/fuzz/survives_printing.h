// A property of any text: either it is refused with messages, or its document survives printing.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "support/diagnostics.h"

namespace robcogen::fuzz {

inline void require(bool holds, const char* what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

template <class Document>
void survives_printing(
    Document (*parse)(std::shared_ptr<const Source>, Diagnostics&),
    const std::uint8_t* data,
    std::size_t size) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<Source>("fuzz", std::string(reinterpret_cast<const char*>(data), size));
  const Document document = parse(source, diagnostics);
  const std::string messages = diagnostics.render(), text = print(document);
  require(messages.empty() == diagnostics.all().empty(), "messages and diagnostics differ", messages);
  if (diagnostics.has_errors()) return;

  Diagnostics of_print;
  const Document again = parse(std::make_shared<Source>("print", text), of_print);
  require(of_print.all().empty(), "the printed document is refused", of_print.render());
  require(equal(document, again), "the printed document is another one", text);
  require(print(again) == text, "the printed document prints differently", text);
}

}  // namespace robcogen::fuzz
