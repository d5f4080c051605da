#include "language/common/frames_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "language/common/parse_expression.h"

namespace robcogen::language {
namespace {

Name name(Cursor& cursor, std::string_view what) {
  const Token token = cursor.expect_name(what);
  return {std::string(token.text), token.span};
}

// Parses names separated by commas, up to `}`. The list may be empty if `may_be_empty`.
std::vector<Name> names(Cursor& cursor, std::string_view section, std::string_view what, bool may_be_empty) {
  cursor.expect("{", fmt::format("after '{}'", section));
  std::vector<Name> list;
  if (may_be_empty && cursor.accept("}")) return list;
  do list.push_back(name(cursor, what));
  while (cursor.accept(","));
  if (!cursor.at("}")) cursor.unexpected("',' or '}'", fmt::format("after '{}'", list.back().text));
  cursor.take();
  return list;
}

void parse_frames(Cursor& cursor, FramesHeader& header) {
  const Token word = cursor.take();
  if (header.frames) cursor.error_at(word.span, "duplicate-item", "'Frames' is given twice");
  header.frames.emplace();
  *header.frames = names(cursor, "Frames", "the name of a frame", false);
}

void parse_group(Cursor& cursor, FramesHeader& header) {
  ParameterGroup group;
  const Token word = cursor.take();
  group.comments = cursor.comments_before(word.span.begin);
  group.name = name(cursor, "the name of a group of parameters");
  group.parameters = names(cursor, group.name.text, "the name of a parameter", true);
  header.groups.push_back(std::move(group));
}

bool same(const Name& a, const Name& b) {
  return a.text == b.text;
}

bool same(const std::vector<Name>& a, const std::vector<Name>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Name& x, const Name& y) { return same(x, y); });
}

bool same(const ParameterGroup& a, const ParameterGroup& b) {
  return same(a.name, b.name) && same(a.parameters, b.parameters) && a.comments == b.comments;
}

bool same(const AxisStep& a, const AxisStep& b) {
  return a.rotation == b.rotation && a.axis == b.axis && equal(*a.amount, *b.amount);
}

std::string print_names(const std::vector<Name>& list, const std::vector<std::string>& keywords) {
  std::string out;
  for (const Name& n : list) out += (out.empty() ? "" : ", ") + print_name(n, keywords);
  return out;
}

}  // namespace

FramesHeader parse_frames_header(Cursor& cursor, std::initializer_list<std::string_view> stops) {
  FramesHeader header;
  const auto at_part = [&] { return cursor.at_any({"Frames", "Params"}) || cursor.at_any(stops); };
  try {
    if (!cursor.at("Model")) cursor.unexpected("'Model'", "at the beginning of the document");
    const Token word = cursor.take();
    header.comments = cursor.comments_before(word.span.begin);
    header.model = name(cursor, "the name of the model");
  } catch (const SyntaxError&) {
    cursor.skip_until(at_part);
    if (cursor.at_end()) throw;
  }
  while (cursor.at_any({"Frames", "Params"})) {
    cursor.begin_statement();
    try {
      if (cursor.at("Frames")) {
        parse_frames(cursor, header);
      } else {
        parse_group(cursor, header);
      }
    } catch (const SyntaxError&) {
      cursor.skip_until(at_part);
      if (cursor.at_end()) throw;
    }
  }
  return header;
}

std::vector<AxisStep> parse_steps(Cursor& cursor, const std::vector<std::string>& words) {
  std::vector<AxisStep> steps;
  while (true) {
    const auto word = std::find_if(words.begin(), words.end(), [&](const std::string& w) { return cursor.at(w); });
    if (word == words.end()) return steps;
    const auto index = static_cast<int>(word - words.begin());
    AxisStep step;
    step.rotation = index >= 3;
    step.axis = index % 3;
    const Token token = cursor.take();
    cursor.expect("(", fmt::format("after '{}'", token.text));
    step.amount = parse_expression(cursor);
    if (cursor.at_decimal_comma()) cursor.decimal_comma(cursor.peek().span);
    step.span = {token.span.begin, cursor.expect(")", fmt::format("at the end of '{}'", token.text)).span.end};
    steps.push_back(std::move(step));
  }
}

std::optional<Name> parse_user_name(Cursor& cursor) {
  if (!cursor.accept("[")) return std::nullopt;
  const Name result = name(cursor, "a name");
  cursor.expect("]", "after the name");
  return result;
}

void unexpected_after_steps(
    Cursor& cursor,
    const std::vector<std::string>& words,
    std::string_view what,
    std::string_view next) {
  std::string expected;
  for (const std::string& word : words) expected += fmt::format("'{}', ", word);
  if (cursor.after_line_end()) cursor.begin_statement();  // report the token, not the end of the previous line
  if (cursor.is_faulty_here() || (!cursor.at(",") && !cursor.at("*")))
    cursor.unexpected(fmt::format("{}'[' or {}", expected, next), "");
  cursor.error("unexpected-token", fmt::format("unexpected '{}' between the steps of {}", cursor.peek().text, what))
      .hint = "steps are separated by blanks only";
  throw SyntaxError{};
}

std::string print_name(const Name& name, const std::vector<std::string>& keywords) {
  const bool is_keyword = std::find(keywords.begin(), keywords.end(), name.text) != keywords.end();
  return is_keyword ? fmt::format("^{}", name.text) : name.text;
}

std::string print_comments(const std::vector<std::string>& comments, const std::string& indent) {
  std::string out;
  for (const std::string& comment : comments) out += indent + comment + "\n";
  return out;
}

std::string print_frames_header(const FramesHeader& header, const std::vector<std::string>& keywords) {
  std::string out = print_comments(header.comments) + "Model " + print_name(header.model, keywords) + "\n\n";
  if (header.frames) out += "Frames {\n    " + print_names(*header.frames, keywords) + "\n}\n\n";
  for (const ParameterGroup& group : header.groups) {
    out += print_comments(group.comments);
    out += "Params " + print_name(group.name, keywords) + " {";
    out += group.parameters.empty() ? "" : "\n    " + print_names(group.parameters, keywords) + "\n";
    out += "}\n\n";
  }
  return out;
}

std::string print_steps(const std::vector<AxisStep>& steps, const std::vector<std::string>& words) {
  std::string out;
  for (const AxisStep& step : steps) {
    const int index = step.axis + (step.rotation ? 3 : 0);
    out += fmt::format(" {}({})", words[static_cast<std::size_t>(index)], print(*step.amount));
  }
  return out;
}

bool equal(const FramesHeader& a, const FramesHeader& b) {
  const bool same_frames = a.frames.has_value() == b.frames.has_value() && (!a.frames || same(*a.frames, *b.frames));
  const bool same_groups = std::equal(
      a.groups.begin(), a.groups.end(), b.groups.begin(), b.groups.end(),
      [](const ParameterGroup& x, const ParameterGroup& y) { return same(x, y); });
  return same(a.model, b.model) && same_frames && same_groups && a.comments == b.comments;
}

bool equal(const std::vector<AxisStep>& a, const std::vector<AxisStep>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const AxisStep& x, const AxisStep& y) { return same(x, y); });
}

}  // namespace robcogen::language
