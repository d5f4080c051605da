#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "language/common/content.h"
#include "language/desired/document.h"
#include "language/desired/keywords.h"
#include "language/desired/parse_section.h"

namespace robcogen::language::desired {
namespace {

// Reports and takes a '{' before the sections, as if they were enclosed in braces like the elements of a robot
// document. Returns whether there is one.
bool take_outer_brace(Cursor& cursor) {
  const auto next = [&](std::string_view word) { return cursor.at(word, 1); };
  if (!cursor.at("{") || std::none_of(kSections.begin(), kSections.end(), next)) return false;
  cursor.error("unexpected-token", "unexpected '{' after the name of the robot").hint =
      "the sections follow the name, without braces around them";
  cursor.take();
  return true;
}

// Returns whether braces enclose the sections.
bool read_header(Cursor& cursor, Name& robot) {
  try {
    if (!cursor.at_any({"Robot", "Model"}))
      cursor.unexpected("'Robot' or 'Model'", "at the beginning of a desired-transforms document");
    cursor.take();
    robot = read_name(cursor, "the name of the robot");
    return take_outer_brace(cursor);
  } catch (const SyntaxError&) {
    cursor.skip_until([&] { return at_section(cursor); });
    if (cursor.at_end()) throw;
    return false;
  }
}

// In the dialect of 2018, `FK name { … }` and `IKpos name { … }` are queries.
[[noreturn]] void report_unknown_section(Cursor& cursor) {
  const std::string_view word = cursor.peek().text;
  if (word == "FK" || word.starts_with("IK")) {
    cursor
        .error("query-dialect", fmt::format("'{}' belongs to the query dialect of 2018, which is not supported", word))
        .hint = "list pairs of frames in 'Transforms { … }' and 'Jacobians { … }'";
    throw OtherLanguage{};
  }
  cursor.unexpected("'Frames', 'Transforms', 'Jacobians', 'Contacts', 'InverseKinematics' or 'Functions'", "");
}

// Takes the word that begins a section and adds it to those found. A document has at most one section of each kind.
Token read_section_word(Cursor& cursor, std::vector<Token>& found) {
  Token word = cursor.take();
  if (cursor.at(word.text)) {
    found.push_back(word);
    word = cursor.take();
  }
  const auto earlier =
      std::find_if(found.begin(), found.end(), [&](const Token& token) { return token.text == word.text; });
  if (earlier != found.end())
    cursor.error_at(word.span, "duplicate-item", fmt::format("'{}' is given twice", word.text))
        .notes.push_back({cursor.place(earlier->span), "first given here"});
  found.push_back(word);
  return word;
}

// The words that begin sections. If errors were skipped, there may be more.
struct FoundSections {
  std::vector<Token> words;
  bool may_have_skipped = false;
};

// After an error in a section or a pair, skips to the next one, or to the end of the block.
FoundSections read_sections(Cursor& cursor, bool are_in_braces, Document& document) {
  FoundSections found;
  while (!cursor.at_end()) {
    cursor.begin_statement();
    try {
      if (are_in_braces && cursor.accept("}")) continue;
      if (!at_section_word(cursor)) report_unknown_section(cursor);
      const Token word = read_section_word(cursor, found.words);
      read_section(cursor, word, document);
    } catch (const SyntaxError&) {
      found.may_have_skipped = true;
      cursor.skip_until([&] { return at_section(cursor); });
    }
  }
  return found;
}

void check_complete(Cursor& cursor, const FoundSections& found, const Name& robot) {
  if (found.may_have_skipped) return;
  for (const char* word : {"Frames", "Transforms"})
    if (std::none_of(found.words.begin(), found.words.end(), [&](const Token& t) { return t.text == word; }))
      cursor.error_at(robot.span, "missing-item", fmt::format("the document has no '{} {{ … }}'", word));
}

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  Document document;
  document.source = source;
  Cursor cursor(tokenize_document(source, diagnostics), keywords(), diagnostics);
  try {
    const bool are_in_braces = read_header(cursor, document.robot);
    const FoundSections found = read_sections(cursor, are_in_braces, document);
    check_complete(cursor, found, document.robot);
  } catch (const SyntaxError&) {
  } catch (const OtherLanguage&) {
    // reported; the rest of the file is not read
  }
  document.comments = cursor.comments_before(source->text().size() + 1);
  return document;
}

}  // namespace robcogen::language::desired
