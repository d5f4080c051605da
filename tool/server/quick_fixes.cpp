#include "server/quick_fixes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "language/common/characters.h"
#include "language/common/lexer.h"
#include "server/text_fixes.h"

namespace robcogen::server {
namespace {

using language::Token;

// Returns the text between the first quotes after `before`; empty if there is none.
std::string quoted_after(const std::string& text, std::string_view before) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) return "";
  const std::size_t open = begin + before.size();
  const std::size_t close = text.find('\'', open);
  return close == std::string::npos ? "" : text.substr(open, close - open);
}

// Returns all texts in quotes.
std::vector<std::string> quoted_in(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t open = text.find('\''); open != std::string::npos;) {
    const std::size_t close = text.find('\'', open + 1);
    if (close == std::string::npos) break;
    result.push_back(text.substr(open + 1, close - open - 1));
    open = text.find('\'', close + 1);
  }
  return result;
}

// Returns the word at the beginning of a place, without a leading '^' or quote.
std::optional<Span> word_at(const Place& place) {
  const std::string_view text = place.source->text();
  std::size_t begin = place.span.begin;
  if (begin < text.size() && (text[begin] == '^' || text[begin] == '"' || text[begin] == '\'')) ++begin;
  std::size_t end = begin;
  while (end < text.size() && language::is_word(text[end])) ++end;
  if (end == begin) return std::nullopt;
  return Span{begin, end};
}

void add_replacements(const Diagnostic& d, const Place& place, std::vector<QuickFix>& fixes) {
  const std::optional<Span> word = word_at(place);
  if (!word) return;
  const std::string_view written = place.source->text().substr(word->begin, word->end - word->begin);
  const std::string meant = quoted_after(d.hint, "did you mean '");
  if (!meant.empty() && meant != written)
    fixes.push_back({fmt::format("Replace '{}' by '{}'", written, meant), {{*word, meant}}});
  const std::string escaped = quoted_after(d.hint, "write '^");
  if (escaped == written && !escaped.empty())
    fixes.push_back({fmt::format("Write '^{}': the name is meant", escaped), {{{word->begin, word->begin}, "^"}}});
}

// The line break to use in changes of a text.
std::string line_break(std::string_view text) {
  return text.find("\r\n") != std::string_view::npos ? "\r\n" : "\n";
}

// Returns the indentation of the line that contains the offset.
std::string indent_of(std::string_view text, std::size_t offset) {
  std::size_t begin = offset;
  while (begin > 0 && text[begin - 1] != '\n' && text[begin - 1] != '\r') --begin;
  std::size_t end = begin;
  while (end < text.size() && (text[end] == ' ' || text[end] == '\t')) ++end;
  return std::string(text.substr(begin, end - begin));
}

std::string with_line_breaks(std::string text, std::string_view line_break) {
  if (line_break == "\n") return text;
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + line_break.size()))
    text.replace(at, 1, line_break);
  return text;
}

// Returns one more than the largest number after the keyword `id`.
std::size_t next_id(const std::vector<Token>& tokens) {
  std::size_t next = 1;
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (tokens[i].text != "id" || tokens[i + 1].text != "=" || tokens[i + 2].kind != Token::Kind::number) continue;
    const double value = language::number_of(tokens[i + 2]).value();
    if (value >= 0 && value < 1e9) next = std::max(next, static_cast<std::size_t>(value) + 1);
  }
  return next;
}

// Returns the offset of the brace that closes the outermost block around the offset.
std::optional<std::size_t> end_of_body(const std::vector<Token>& tokens, std::size_t offset) {
  int open = 0;
  for (const Token& token : tokens) {
    if (token.text == "{" && token.kind == Token::Kind::symbol) ++open;
    if (token.text != "}" || token.kind != Token::Kind::symbol) continue;
    if (--open == 0 && token.span.begin > offset) return token.span.begin;
  }
  return std::nullopt;
}

constexpr std::string_view kPlacement = "{ translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) }";

void add_declaration(const Diagnostic& d, const Place& place, std::vector<QuickFix>& fixes) {
  const std::optional<Span> word = word_at(place);
  if (!word) return;
  Diagnostics ignored;
  const language::TokenList list = language::tokenize(place.source, ignored);
  const std::string_view text = place.source->text();
  std::optional<std::size_t> end = end_of_body(list.tokens, place.span.begin);
  if (!end) return;
  while (*end > 0 && (text[*end - 1] == ' ' || text[*end - 1] == '\t')) --*end;
  const std::string name(text.substr(word->begin, word->end - word->begin));
  const std::string declared =
      d.code == "unknown-link"
          ? fmt::format("    link {} {{\n        id = {}\n        children {{}}\n    }}\n", name, next_id(list.tokens))
          : fmt::format("    r_joint {} {{\n        ref_frame {}\n    }}\n", name, kPlacement);
  const bool begins_line = *end == 0 || text[*end - 1] == '\n' || text[*end - 1] == '\r';
  fixes.push_back(
      {fmt::format("Declare {} '{}'", d.code == "unknown-link" ? "link" : "joint", name),
       {{{*end, *end}, with_line_breaks((begins_line ? "" : "\n") + declared, line_break(text))}}});
}

// The text that stands for an item until the user writes it.
std::string placeholder(const std::string& item, std::size_t id) {
  static const std::map<std::string, std::string> known = {
      {"children", "children {}"},
      {"CoM", "CoM = (0.0, 0.0, 0.0)"},
      {"translation", "translation = (0.0, 0.0, 0.0)"},
      {"rotation", "rotation = (0.0, 0.0, 0.0)"},
      {"ref_frame", "ref_frame " + std::string(kPlacement)},
      {"pitch", "pitch = 0.01 / (2.0 PI)"}};
  if (item == "id") return fmt::format("id = {}", id);
  const auto found = known.find(item);
  return found != known.end() ? found->second : item + " = 0.0";
}

// Fixes `the document has no 'Frames { … }'`.
void add_missing_lists(const Diagnostic& d, const Place& place, std::vector<QuickFix>& fixes) {
  const std::string_view text = place.source->text();
  for (const std::string& list : quoted_in(d.message)) {
    const std::string word = list.substr(0, list.find(' '));
    const bool begins_line = text.empty() || text.ends_with('\n');
    const std::string added = fmt::format("{}{} {{\n}}\n", begins_line ? "" : "\n", word);
    fixes.push_back(
        {fmt::format("Add '{}'", word), {{{text.size(), text.size()}, with_line_breaks(added, line_break(text))}}});
  }
}

// Fixes `link 'a' has no 'id', 'children'`: inserts the items after the brace that opens the block.
void add_missing_items(const Diagnostic& d, const Place& place, std::vector<QuickFix>& fixes) {
  const std::size_t words = d.message.rfind(" has no ");
  if (words == std::string::npos) return;
  if (place.source->name().ends_with(".dtdsl")) return add_missing_lists(d, place, fixes);
  Diagnostics ignored;
  const language::TokenList list = language::tokenize(place.source, ignored);
  std::size_t i = 0;
  while (i < list.tokens.size() && list.tokens[i].span.begin < place.span.end) ++i;
  while (i < list.tokens.size() && list.tokens[i].text != "{") ++i;
  if (i >= list.tokens.size()) return;
  const std::string_view text = place.source->text();
  const std::string indent = indent_of(text, list.tokens[i].span.begin) + "    ";
  const bool goes_on = i + 1 < list.tokens.size() && place.source->locate(list.tokens[i].span.begin).line ==
                                                         place.source->locate(list.tokens[i + 1].span.begin).line;
  std::string items;
  for (const std::string& item : quoted_in(d.message.substr(words)))
    items += "\n" + indent + placeholder(item, next_id(list.tokens));
  if (goes_on) items += "\n" + indent;
  fixes.push_back(
      {"Add what is missing",
       {{{list.tokens[i].span.end, list.tokens[i].span.end}, with_line_breaks(items, line_break(text))}}});
}

}  // namespace

std::vector<QuickFix> quick_fixes(const Diagnostic& diagnostic) {
  const Place place = written_at(diagnostic.place);
  std::vector<QuickFix> fixes;
  if (!place.source) return fixes;
  add_replacements(diagnostic, place, fixes);
  add_text_fixes(diagnostic, place, fixes);
  const bool is_robot =
      diagnostic.message.find("URDF") == std::string::npos && !place.source->name().ends_with(".urdf");
  if (!is_robot) return fixes;
  const bool is_undeclared = diagnostic.code == "unknown-link" || diagnostic.code == "unknown-joint";
  if (is_undeclared && diagnostic.message.ends_with("is not declared")) add_declaration(diagnostic, place, fixes);
  if (diagnostic.code == "missing-item") add_missing_items(diagnostic, place, fixes);
  return fixes;
}

}  // namespace robcogen::server
