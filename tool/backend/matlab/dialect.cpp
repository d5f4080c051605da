#include "backend/matlab/dialect.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <unordered_set>

#include "backend/common/layout.h"

namespace robcogen::backend::matlab {
namespace {

constexpr auto kWords = std::to_array<std::string_view>({
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
    "isempty",
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
    "tril",
    "true",
    "zeros",
});

// A file of such a name would shadow the function, and a variable would hide it from the rest of its function.
constexpr std::string_view kFunctions[] = {
#include "backend/matlab/functions.inc"
};

// Functions of MATLAB that Octave does not have, and whose names a model may use.
constexpr auto kMatlabFunctions = std::to_array<std::string_view>(
    {"arguments", "categorical", "containers", "contains", "datetime", "digraph", "duration", "extract",
     "graph",     "height",      "import",     "join",     "matlab",   "meta",    "missing",  "pad",
     "replace",   "split",       "string",     "strings",  "table",    "tall",    "timer",    "width"});

bool is_word(const std::string& name) {
  return std::find(kWords.begin(), kWords.end(), name) != kWords.end();
}

bool is_function(const std::string& name) {
  static const std::unordered_set<std::string_view> functions = [] {
    std::unordered_set<std::string_view> all(std::begin(kFunctions), std::end(kFunctions));
    all.insert(kMatlabFunctions.begin(), kMatlabFunctions.end());
    return all;
  }();
  return functions.count(name) > 0;
}

// Names of results that readers expect. The functions that return them do not need the Octave functions of these names.
bool is_quantity(const std::string& name) {
  return name == "J" || name == "inverse";
}

Spelling literal(const Number& value, Texts& texts) {
  return backend::literal(number(value.value()), texts);
}

std::string element(const std::string& array, std::size_t k) {
  return array + "(" + std::to_string(k + 1) + ")";
}

}  // namespace

bool is_reserved_file(const std::string& name) {
  return is_word(name) || is_function(name);
}

bool is_reserved(const std::string& name) {
  return is_reserved_file(name) && !is_quantity(name);
}

const Dialect& dialect() {
  static const Dialect matlab = [] {
    Dialect d = returning_dialect(kColumns);
    d.is_reserved = is_reserved;
    d.used_names = {"atan2", "cos", "error", "isempty", "isstruct", "nargin", "names",
                    "numel", "sin", "size",  "sqrt",    "strjoin",  "tril",   "zeros"};
    d.name_limit = 26;  // three such operands and their operators fit in one line
    d.binds_parameters = true;
    d.names_variables = true;
    d.literal = literal;
    d.element = element;
    d.members = fields;
    d.section = [](const std::string& text) { return comment(text, 2); };
    return d;
  }();
  return matlab;
}

std::vector<std::string> fields(const std::vector<std::string>& parameters) {
  return claim_all(parameters, is_word);
}

std::string upper_case(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

std::string number(double value) {
  return short_number(value, "NaN", "Inf");
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string comment(const std::string& text, std::size_t indent, std::size_t hanging) {
  const std::string margin = std::string(indent, ' ') + "% ";
  std::string clean;
  for (const char c : text)
    if (c != '`') clean += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return wrapped_text(clean, kColumns, margin, margin + std::string(hanging, ' '));
}

std::string wrapped(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::string& tail,
    const std::string& separator) {
  const ListLayout layout = {
      .columns = kColumns, .openers = "([{", .separator = separator, .continuation = " ...", .keeps_first = false};
  return backend::wrapped(layout, head, items, tail);
}

std::string matrix(const std::string& target, const std::vector<std::vector<std::string>>& rows) {
  const std::string head = "  " + target + " = ";
  if (rows.size() == 1 && rows.front().size() == 1) return head + rows.front().front() + ";\n";
  if (rows.size() == 1 || rows.front().size() == 1) {
    std::vector<std::string> items;
    for (const std::vector<std::string>& row : rows) items.insert(items.end(), row.begin(), row.end());
    return wrapped(head + "[", items, "];", rows.size() == 1 ? "," : ";");
  }
  std::string result = head + "[ ...\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const bool is_last = r + 1 == rows.size();
    result += wrapped("    " + rows[r].front() + ",", {rows[r].begin() + 1, rows[r].end()}, is_last ? "];" : "; ...");
  }
  return result;
}

}  // namespace robcogen::backend::matlab
