// What the fuzz targets share: the entry point that libFuzzer and the replay call, and a check that ends the program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "support/diagnostics.h"
#include "symbolic/interpret.h"
#include "symbolic/text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace robcogen::fuzz {

inline void require(bool holds, const char* what, const std::string& detail = "") {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n%s\n", what, detail.c_str());
  std::abort();
}

inline std::shared_ptr<const Source> source(const std::uint8_t* data, std::size_t size) {
  return std::make_shared<Source>("fuzz", std::string(reinterpret_cast<const char*>(data), size));
}

// Messages render, and each has a code and a text.
inline void check_messages(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics.all()) {
    require(!d.code.empty() && !d.message.empty(), "a diagnostic has a code and a message");
    if (!d.place.source) continue;
    require(d.place.span.begin <= d.place.span.end, "a span ends after it begins", d.message);
    require(d.place.span.end <= d.place.source->text().size(), "a place is in its text", d.message);
  }
  diagnostics.render(ErrorFormat::gnu);
  diagnostics.render(ErrorFormat::msvc);
}

// What is printed reads back as the same document, and prints the same.
template <class Document>
void check_round_trip(
    const Document& document,
    Document (*parse)(std::shared_ptr<const Source>, Diagnostics&),
    std::string (*print)(const Document&),
    bool (*equal)(const Document&, const Document&)) {
  const std::string text = print(document);
  Diagnostics diagnostics;
  const Document again = parse(std::make_shared<Source>("printed", text), diagnostics);
  require(!diagnostics.has_errors(), "a printed document is well-formed", diagnostics.render() + text);
  require(equal(document, again), "a printed document says the same", text);
  require(print(again) == text, "printing is idempotent", text + "\n--- again:\n" + print(again));
}

// Sound, and it runs.
inline void check_program(const symbolic::Program& program) {
  const std::string fault = symbolic::verify(program);
  require(fault.empty(), "a program is sound", fault + "\n" + symbolic::print(program));
  symbolic::Arrays<double> inputs;
  double value = 0.1;
  for (const symbolic::InputArray& array : program.inputs)
    for (std::size_t k = 0; k < array.elements.size(); ++k) inputs[array.name].push_back(value += 0.3);
  symbolic::interpret(program, inputs);
}

}  // namespace robcogen::fuzz
