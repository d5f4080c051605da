#include "backend/javascript/text.h"

#include <string_view>

#include "backend/common/layout.h"

namespace robcogen::backend::javascript {
namespace {

// Words that no variable of a module may have as its name, and global values that the text may refer to.
constexpr std::string_view kReserved =
    " Infinity NaN arguments await break case catch class const continue debugger default delete do else enum eval "
    "export extends false finally for function if implements import in instanceof interface let new null package "
    "private protected public return static super switch this throw true try typeof undefined var void while with "
    "yield ";

bool is_reserved(const std::string& name) {
  return kReserved.find(" " + name + " ") != std::string_view::npos;
}

}  // namespace

const Dialect& dialect() {
  static const Dialect javascript = [] {
    Dialect d = returning_dialect(kColumns);
    d.is_reserved = is_reserved;
    d.used_names = {"Rx", "Ry", "Rz", "Tx", "Ty", "Tz", "atan2", "cos", "multiply", "primitives", "sin", "sqrt"};
    d.name_limit = 26;  // three such operands and their operators fit in one line
    d.binds_parameters = true;
    d.names_variables = true;
    d.literal = [](const Number& value, Texts& texts) { return literal(number(value.value()), texts); };
    d.element = subscripted;
    d.members = members;
    d.definition = "const ";
    d.section = [](const std::string& text) { return comment_lines({text}, "  // "); };
    return d;
  }();
  return javascript;
}

std::vector<std::string> members(const std::vector<std::string>& parameters) {
  return claim_all(parameters, is_free);  // a member may have any name
}

std::string number(double value) {
  return short_number(value, "NaN", "Infinity");
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result + "\"";
}

std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail) {
  return backend::wrapped({.columns = kColumns}, head, items, tail);
}

std::string comment_lines(const std::vector<std::string>& lines, const std::string& margin) {
  std::string result;
  for (std::string line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool ends_line = static_cast<unsigned char>(line[i]) < ' ' || line.compare(i, 2, "\xE2\x80") == 0;
      if (ends_line || (i > 0 && line[i] == '/' && line[i - 1] == '*')) line[i] = ' ';
    }
    result += wrapped_text(line, kColumns, margin, margin + "  ");
  }
  return result;
}

}  // namespace robcogen::backend::javascript
