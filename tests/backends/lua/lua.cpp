#include "lua.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "backend/common/layout.h"
#include "backend/common/lower.h"
#include "support/concat.h"
#include "support/number.h"

namespace robcogen::backend::lua {
namespace {

const char* const kReserved[] = {"and",      "break",  "do",     "else", "elseif", "end",   "false", "for",
                                 "function", "goto",   "if",     "in",   "local",  "math",  "nil",   "not",
                                 "or",       "repeat", "return", "then", "true",   "until", "while"};

const Dialect& dialect() {
  static const Dialect lua = [] {
    Dialect d = returning_dialect(100);
    d.is_reserved = [](const std::string& name) {
      return std::find(std::begin(kReserved), std::end(kReserved), name) != std::end(kReserved);
    };
    d.sine = "math.sin";
    d.cosine = "math.cos";
    d.square_root = "math.sqrt";
    d.arc_tangent = "math.atan";
    d.definition = "local ";
    d.end = "";
    d.literal = [](const Number& value, Texts& texts) { return literal(print_double(value.value()), texts); };
    d.element = [](const std::string& array, std::size_t k) { return subscripted(array, k + 1); };
    d.section = [](const std::string& title) { return "  -- " + title + "\n"; };
    return d;
  }();
  return lua;
}

std::string print_function(const Function& f) {
  const Kernel kernel = lower(f.program, f.kernel, dialect());
  std::vector<std::string> arguments = names_of(kernel.parameters), results;
  arguments.resize(f.program.inputs.size());
  for (const std::vector<std::string>& elements : kernel.results) results.push_back("{" + joined(elements) + "}");
  return "\n-- " + f.summary.front() + "\nfunction M." + f.kernel + "(" + joined(arguments) + ")\n" +
         body(kernel, dialect()) + "  return " + joined(results) + "\nend\n";
}

}  // namespace

std::vector<OutputFile> print(const Library& library) {
  std::string text = "-- " + library.title() + "\nlocal M = {}\n";
  for (const Function& f : library.functions) text += print_function(f);
  return {{library.name + ".lua", text + "\nreturn M\n"}};
}

}  // namespace robcogen::backend::lua
