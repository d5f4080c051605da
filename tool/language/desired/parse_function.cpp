#include "language/desired/parse_function.h"

#include <fmt/format.h>

#include <utility>

#include "language/desired/keywords.h"
#include "language/desired/parse_frame.h"

namespace robcogen::language::desired {
namespace {

// As in C++, `::` separates a scope too.
bool accept_separator(Cursor& cursor) {
  if (cursor.accept(".")) return true;
  if (!cursor.at(":") || !cursor.at(":", 1)) return false;
  cursor.take();
  cursor.take();
  return true;
}

// Parses `bias_forces`, `jacobians.fr_base_J_fr_foot` or `transforms.homogeneous.fr_base_X_fr_foot`.
Name read_part(Cursor& cursor) {
  if (cursor.at("=", 1)) cursor.unexpected("the name of a function", "");  // the next definition begins here
  Name part = read_name(cursor, "the name of a function");
  while (accept_separator(cursor)) {
    const Name next = read_name(cursor, fmt::format("the name of a function after '{}.'", part.text));
    part.text += "." + next.text;
    part.span.end = next.span.end;
  }
  return part;
}

}  // namespace

Function read_function(Cursor& cursor) {
  Function function;
  function.name = read_name(cursor, "the name of a function");
  cursor.expect("=", fmt::format("after '{}'", function.name.text), "write 'name = function + function'");
  do function.parts.push_back(read_part(cursor));
  while (cursor.accept("+"));
  return function;
}

std::vector<Function> parse_functions(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  std::vector<Function> functions;
  Cursor cursor(tokenize(std::move(source), diagnostics), keywords(), diagnostics);
  while (!cursor.at_end()) {
    cursor.begin_statement();
    try {
      functions.push_back(read_function(cursor));
    } catch (const SyntaxError&) {
      cursor.skip_until([&] { return cursor.at_name() && cursor.at("=", 1); });
    }
  }
  return functions;
}

}  // namespace robcogen::language::desired
