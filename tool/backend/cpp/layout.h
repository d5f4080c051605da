// Layout of generated C++ as the project's .clang-format has it: 120 columns, and one parameter per line if the
// parameters do not fit in one.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "backend/common/c_text.h"

namespace robcogen::backend::cpp {

using c_family::banner;
using c_family::braced;
using c_family::comment;
using c_family::kColumns;
using c_family::quoted;

// `head(parameters) tail`, as in `inline JointState f(const JointState& q) noexcept {`.
std::string declaration(
    const std::string& head,
    const std::vector<std::string>& parameters,
    const std::string& tail,
    std::size_t indent = 0);

// `head(arguments);` as a statement.
std::string call(const std::string& head, const std::vector<std::string>& arguments, std::size_t indent);

// `head<items>tail;` as a statement, where the tail holds arguments in parentheses.
std::string template_call(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::string& tail,
    std::size_t indent);

// `head = {…};` with one item per line, each followed by its remark. (Without remarks, clang-format would arrange long
// lists in columns.)
std::string remarked_list(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::vector<std::string>& remarks,
    std::size_t indent = 0);

// `head = {items};` on one line if the items fit, otherwise one item per line, each with its number.
std::string numbered_list(const std::string& head, const std::vector<std::string>& items, std::size_t indent = 0);
// A list of texts with their numbers. Texts longer than a line are split into pieces.
std::string text_list(const std::string& head, const std::vector<std::string>& texts);

// A field of a table: one item, a list in braces, or a template with a list of arguments.
struct Field {
  Field(const char* text) : items{text} {}
  Field(const std::string& text) : items{text} {}
  Field(int number) : items{std::to_string(number)} {}
  Field(std::vector<std::string> list) : items(std::move(list)), braces(true) {}
  Field(std::string name, std::vector<std::string> arguments)
      : items(std::move(arguments)), template_name(std::move(name)) {}

  std::vector<std::string> items;
  bool braces = false;
  std::string template_name;
};

// `head = {…};` with one row per line, each with its number; one field per line if rows are too long for that.
std::string table(const std::string& head, const std::vector<std::vector<Field>>& rows);

// The parts, separated by blank lines; empty parts vanish.
std::string paragraphs(const std::vector<std::string>& parts);

// `namespace a::b { … }`; empty if the body is empty.
std::string in_namespace(const std::string& name, const std::string& body);

}  // namespace robcogen::backend::cpp
