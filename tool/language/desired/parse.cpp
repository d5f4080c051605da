#include <fmt/format.h>

#include <algorithm>

#include "language/common/content.h"
#include "language/common/cursor.h"
#include "language/desired/document.h"
#include "language/desired/keywords.h"

namespace robcogen::language::desired {
namespace {

// A section or a pair that fails is skipped up to the next one, or to the end of its block.
class Parser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), cursor_(tokenize_document(source_, diagnostics), keywords(), diagnostics) {
    document_.source = source_;
  }

  Document run() {
    try {
      header();
      sections();
      check_complete();
    } catch (const SyntaxError&) {
    } catch (const OtherLanguage&) {
      // reported; nothing further can be made of the file
    }
    document_.comments = cursor_.comments_before(source_->text().size() + 1);
    return std::move(document_);
  }

 private:
  std::shared_ptr<const Source> source_;
  Cursor cursor_;
  Document document_;
  std::vector<Token> found_;  // the words that begin sections
  bool section_may_be_missed_ = false;

  void header() {
    try {
      if (!cursor_.at_any({"Robot", "Model"}))
        cursor_.unexpected("'Robot' or 'Model'", "at the beginning of a desired-transforms document");
      cursor_.take();
      document_.robot = name("the name of the robot");
    } catch (const SyntaxError&) {
      cursor_.skip_until([&] { return at_section(); });
      if (cursor_.at_end()) throw;
    }
  }

  bool at_section() const { return cursor_.at_any({"Frames", "Transforms", "Jacobians"}) && cursor_.at("{", 1); }

  void sections() {
    while (!cursor_.at_end()) {
      try {
        if (!cursor_.at_any({"Frames", "Transforms", "Jacobians"})) unknown_section();
        const Token word = section_word();
        if (word.text == "Frames") {
          frames();
        } else {
          pairs(word, word.text == "Transforms" ? document_.transforms : document_.jacobians);
        }
      } catch (const SyntaxError&) {
        section_may_be_missed_ = true;
        cursor_.skip_until([&] { return at_section(); });
      }
    }
  }

  Token section_word() {
    const Token word = cursor_.take();
    const auto earlier =
        std::find_if(found_.begin(), found_.end(), [&](const Token& token) { return token.text == word.text; });
    if (earlier != found_.end())
      cursor_.error_at(word.span, "duplicate-item", fmt::format("a second '{}'", word.text))
          .notes.push_back({cursor_.place(earlier->span), "first one here"});
    found_.push_back(word);
    return word;
  }

  // The dialect of 2018 asked for quantities by query: `FK name { … }`, `IKpos name { … }`.
  [[noreturn]] void unknown_section() {
    const std::string_view word = cursor_.peek().text;
    if (word == "FK" || word.starts_with("IK")) {
      cursor_
          .error(
              "query-dialect", fmt::format("'{}' belongs to the query dialect of 2018, which is not supported", word))
          .hint = "list pairs of frames in 'Transforms { … }' and 'Jacobians { … }'";
      throw OtherLanguage{};
    }
    cursor_.unexpected("'Frames', 'Transforms' or 'Jacobians'", "");
  }

  void check_complete() {
    for (const char* word : {"Frames", "Transforms"}) {
      const bool found = std::any_of(found_.begin(), found_.end(), [&](const Token& t) { return t.text == word; });
      if (!found && !section_may_be_missed_)
        cursor_.error_at(document_.robot.span, "missing-item", fmt::format("the document lacks '{} {{ … }}'", word));
    }
  }

  Name name(std::string_view what) {
    const Token token = cursor_.expect_name(what);
    return {std::string(token.text), token.span};
  }

  [[noreturn]] void missing_brace(std::string_view section, const Token& open) {
    cursor_.error("missing-brace", fmt::format("the '}}' of '{}' is missing before this", section))
        .notes.push_back({cursor_.place(open.span), "opened here"});
    throw SyntaxError{};
  }

  void frames() {
    const Token open = cursor_.expect("{", "after 'Frames'");
    while (!cursor_.at("}")) {
      if (at_section()) missing_brace("Frames", open);
      if (cursor_.accept(",") && cursor_.at("}")) cursor_.unexpected("the name of a frame", "after ','");
      document_.frames.push_back(name("the name of a frame"));
    }
    cursor_.take();
  }

  void pairs(const Token& section, std::vector<Pair>& list) {
    const Token open = cursor_.expect("{", fmt::format("after '{}'", section.text));
    while (!cursor_.at("}")) {
      try {
        if (at_section()) missing_brace(section.text, open);
        list.push_back(pair());
      } catch (const SyntaxError&) {
        skip_to_pair();
        if (cursor_.at_end() || at_section()) throw;
      }
    }
    cursor_.take();
  }

  bool at_left() const { return cursor_.at_any({"base", "left", "left_frame"}); }
  bool at_right() const { return cursor_.at_any({"target", "right", "right_frame"}); }
  bool at_pair() const {
    return at_left() || at_right() || (cursor_.at_name() && (cursor_.at("->", 1) || cursor_.at("<-", 1)));
  }
  void skip_to_pair() {
    cursor_.skip_until([&] { return cursor_.at("}") || at_pair() || at_section(); });
  }

  Pair pair() {
    Pair pair;
    const std::size_t begin = cursor_.peek().span.begin;
    if (at_left() || at_right()) {
      sides(pair);
    } else {
      arrow(pair);
    }
    pair.span = {begin, cursor_.previous().span.end};
    return pair;
  }

  void sides(Pair& pair) {
    const bool left_first = at_left();
    const Name first = first_side();
    cursor_.accept(",");
    if (left_first ? !at_right() : !at_left()) wrong_second_side(left_first);
    const Name second = side();
    pair.left = left_first ? first : second;
    pair.right = left_first ? second : first;
  }

  // When it is faulty, the second side that follows is no pair of its own.
  Name first_side() {
    const bool left_first = at_left();
    try {
      return side();
    } catch (const SyntaxError&) {
      skip_to_pair();
      if (left_first ? at_right() : at_left()) side();
      throw;
    }
  }

  [[noreturn]] void wrong_second_side(bool left_first) {
    const bool repeated = at_left() || at_right();
    try {
      cursor_.unexpected(
          left_first ? "'target', 'right' or 'right_frame'" : "'base', 'left' or 'left_frame'",
          left_first ? "after the left frame" : "after the right frame");
    } catch (const SyntaxError&) {
      if (repeated) side();
      throw;
    }
  }

  Name side() {
    const Token word = cursor_.take();
    try {
      cursor_.expect("=", fmt::format("after '{}'", word.text));
    } catch (const SyntaxError&) {
      if (!cursor_.at_name()) throw;  // else the '=' is all that is missing
    }
    return name("the name of a frame");
  }

  // `A <- B` means A_X_B, `A -> B` means B_X_A.
  void arrow(Pair& pair) {
    const Name first = name("a pair of frames");
    if (!cursor_.at_any({"->", "<-"})) cursor_.unexpected("'->' or '<-'", fmt::format("after '{}'", first.text));
    const bool to_first = cursor_.take().text == "<-";
    const Name second = name("the name of a frame");
    pair.left = to_first ? first : second;
    pair.right = to_first ? second : first;
  }
};

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::desired
