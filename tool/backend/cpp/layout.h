// Layout of generated C++ as the project's .clang-format wants it: 120 columns, one parameter a line where they do not
// fit in one.
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

// `head<items>tail;` as a statement, the tail being arguments in parentheses.
std::string template_call(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::string& tail,
    std::size_t indent);

// `head = {…};` with one item a line and the remark of each behind it. (Without remarks clang-format would arrange long
// lists in columns.)
std::string remarked_list(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::vector<std::string>& remarks,
    std::size_t indent = 0);

// `head = {items};` in one line if they fit, else one a line, each with its number.
std::string numbered_list(const std::string& head, const std::vector<std::string>& items, std::size_t indent = 0);
// Texts, in pieces where they are longer than a line; with their numbers.
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

// `head = {…};` with one row of fields a line, each with its number; one field a line where rows are too long for that.
std::string table(const std::string& head, const std::vector<std::vector<Field>>& rows);

// Text with blank lines between the parts; empty parts vanish.
std::string paragraphs(const std::vector<std::string>& parts);

// `namespace a::b { … }`, or nothing around nothing.
std::string in_namespace(const std::string& name, const std::string& body);

}  // namespace robcogen::backend::cpp
