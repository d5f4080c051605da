#include "backend/matlab/dialect.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "support/number.h"

namespace robcogen::backend::matlab {
namespace {

constexpr auto kReserved = std::to_array<std::string_view>({
    // keywords of both
    "break",
    "case",
    "catch",
    "classdef",
    "continue",
    "do",
    "else",
    "elseif",
    "end",
    "end_try_catch",
    "end_unwind_protect",
    "endclassdef",
    "endenumeration",
    "endevents",
    "endfor",
    "endfunction",
    "endif",
    "endmethods",
    "endparfor",
    "endproperties",
    "endswitch",
    "endwhile",
    "enumeration",
    "events",
    "for",
    "function",
    "global",
    "if",
    "methods",
    "otherwise",
    "parfor",
    "persistent",
    "properties",
    "return",
    "spmd",
    "static",
    "switch",
    "try",
    "until",
    "unwind_protect",
    "unwind_protect_cleanup",
    "while",
    // constants and functions
    "Inf",
    "NA",
    "NaN",
    "abs",
    "ans",
    "cell",
    "cos",
    "double",
    "e",
    "eps",
    "false",
    "i",
    "inf",
    "j",
    "max",
    "min",
    "nan",
    "nargin",
    "nargout",
    "ones",
    "pi",
    "sin",
    "size",
    "sqrt",
    "struct",
    "sum",
    "true",
    "zeros",
});

std::string joined(const std::vector<std::string>& items, const std::string& separator) {
  std::string result;
  for (const std::string& item : items) result += (result.empty() ? "" : separator) + item;
  return result;
}

std::string text(const Line& line) {
  if (line.kind == Line::Kind::section) return "% " + line.expression;
  return joined(line.targets, ", ") + " = " + line.expression + ";";
}

Spelling literal(const Number& value) {
  const std::string number = print_double(value.value());
  return backend::literal(number, "-" + number);
}

std::string element(const std::string& array, std::size_t k) {
  return array + "(" + std::to_string(k + 1) + ")";
}

}  // namespace

bool is_reserved(const std::string& name) {
  return std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end();
}

const Dialect& dialect() {
  static const Dialect matlab = [] {
    Dialect d;
    d.is_reserved = is_reserved;
    d.used_names = {"cos", "nargin", "sin", "sqrt", "zeros"};
    d.line_limit = kColumns - 4;  // inside a branch
    d.name_limit = 26;            // three such operands and their operators fit in one line
    d.pairs_angles = false;
    d.stores = false;
    d.literal = literal;
    d.element = element;
    d.text = text;
    return d;
  }();
  return matlab;
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string comment(const std::string& text, std::size_t indent) {
  const std::string prefix = std::string(indent, ' ') + "% ";
  std::string clean = text, result;
  for (char& c : clean)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  while (clean.size() + prefix.size() > kColumns) {
    std::size_t cut = clean.rfind(' ', kColumns - prefix.size());
    if (cut == std::string::npos || cut == 0) cut = clean.find(' ', 1);
    if (cut == std::string::npos) break;
    result += prefix + clean.substr(0, cut) + "\n";
    clean.erase(0, cut + 1);
  }
  return result + prefix + clean + "\n";
}

std::string assignment(
    const std::string& target,
    const std::vector<std::vector<std::string>>& rows,
    std::size_t indent) {
  const std::string margin(indent, ' ');
  std::vector<std::string> texts;
  for (const std::vector<std::string>& row : rows) texts.push_back(joined(row, ", "));
  const std::string head = margin + target + " = ";
  if (rows.size() == 1 && rows.front().size() == 1) return head + texts.front() + ";\n";
  const std::string line = head + "[" + joined(texts, "; ") + "];\n";
  if (line.size() <= kColumns) return line;

  std::string result = head + "[ ...\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string current = margin + "   ";
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const std::string item = " " + rows[r][c] + (c + 1 < rows[r].size() ? "," : r + 1 < rows.size() ? ";" : "];");
      if (current.size() + item.size() + 4 > kColumns) {
        result += current + " ...\n";
        current = margin + "     ";
      }
      current += item;
    }
    result += current + (r + 1 < rows.size() ? " ...\n" : "\n");
  }
  return result;
}

}  // namespace robcogen::backend::matlab
