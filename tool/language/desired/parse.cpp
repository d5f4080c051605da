#include <fmt/format.h>

#include <algorithm>

#include "language/common/content.h"
#include "language/common/cursor.h"
#include "language/desired/document.h"
#include "language/desired/keywords.h"

namespace robcogen::language::desired {
namespace {

// After an error in a section or a pair, the parser skips to the next one, or to the end of the block.
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
      // reported; the rest of the file is not read
    }
    document_.comments = cursor_.comments_before(source_->text().size() + 1);
    return std::move(document_);
  }

 private:
  std::shared_ptr<const Source> source_;
  Cursor cursor_;
  Document document_;
  std::vector<Token> found_;  // the words that begin sections
  bool may_have_skipped_section_ = false;
  std::size_t pair_begin_ = 0;  // of the present pair
  bool pair_begins_line_ = false;
  bool equals_is_reported_ = false;

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

  // 'Contacts' is no reserved word: a frame may have this name.
  bool at_section_word() const { return cursor_.at_any({"Frames", "Transforms", "Jacobians", "Contacts"}); }
  bool at_section() const { return at_section_word() && cursor_.at("{", 1); }

  void sections() {
    while (!cursor_.at_end()) {
      cursor_.begin_statement();
      try {
        if (!at_section_word()) unknown_section();
        const Token word = section_word();
        if (word.text == "Frames") {
          frames();
        } else if (word.text == "Contacts") {
          contacts();
        } else {
          pairs(word, word.text == "Transforms" ? document_.transforms : document_.jacobians);
        }
      } catch (const SyntaxError&) {
        may_have_skipped_section_ = true;
        cursor_.skip_until([&] { return at_section(); });
      }
    }
  }

  Token section_word() {
    Token word = cursor_.take();
    if (cursor_.at(word.text)) {
      found_.push_back(word);
      word = cursor_.take();
    }
    const auto earlier =
        std::find_if(found_.begin(), found_.end(), [&](const Token& token) { return token.text == word.text; });
    if (earlier != found_.end())
      cursor_.error_at(word.span, "duplicate-item", fmt::format("'{}' is given twice", word.text))
          .notes.push_back({cursor_.place(earlier->span), "first given here"});
    found_.push_back(word);
    return word;
  }

  // In the dialect of 2018, `FK name { … }` and `IKpos name { … }` are queries.
  [[noreturn]] void unknown_section() {
    const std::string_view word = cursor_.peek().text;
    if (word == "FK" || word.starts_with("IK")) {
      cursor_
          .error(
              "query-dialect", fmt::format("'{}' belongs to the query dialect of 2018, which is not supported", word))
          .hint = "list pairs of frames in 'Transforms { … }' and 'Jacobians { … }'";
      throw OtherLanguage{};
    }
    cursor_.unexpected("'Frames', 'Transforms', 'Jacobians' or 'Contacts'", "");
  }

  void check_complete() {
    for (const char* word : {"Frames", "Transforms"}) {
      const bool found = std::any_of(found_.begin(), found_.end(), [&](const Token& t) { return t.text == word; });
      if (!found && !may_have_skipped_section_)
        cursor_.error_at(document_.robot.span, "missing-item", fmt::format("the document has no '{} {{ … }}'", word));
    }
  }

  Name name(std::string_view what) {
    const Token token = cursor_.expect_name(what);
    return {std::string(token.text), token.span};
  }

  [[noreturn]] void missing_brace(std::string_view section, const Token& open) {
    cursor_
        .error(
            "missing-brace",
            fmt::format("expected '}}' at the end of '{}', found {}", section, describe(cursor_.peek())))
        .notes.push_back({cursor_.place(open.span), "opened here"});
    throw SyntaxError{};
  }

  // The names of a section; calls element() at each.
  template <class Element>
  void list(std::string_view section, const Element& element) {
    const Token open = cursor_.expect("{", fmt::format("after '{}'", section));
    while (!cursor_.at("}")) {
      cursor_.begin_statement();
      if (at_section()) missing_brace(section, open);
      if (cursor_.accept(",") && cursor_.at("}")) cursor_.unexpected("the name of a frame", "after ','");
      element();
      if (cursor_.at("-") || cursor_.at(".")) cursor_.unexpected("',' or '}'", "after the name of a frame");
    }
    cursor_.take();
  }

  void frames() {
    list("Frames", [&] { document_.frames.push_back(name("the name of a frame")); });
  }

  // `fr_foot`, `point fr_foot`, `surface fr_sole`.
  void contacts() {
    list("Contacts", [&] {
      const bool has_kind = cursor_.at_any({"point", "surface"}) && cursor_.at_name(1);
      const bool is_surface = has_kind && cursor_.take().text == "surface";
      document_.contacts.push_back({name("the name of a frame"), is_surface});
    });
  }

  void pairs(const Token& section, std::vector<Pair>& list) {
    const Token open = cursor_.expect("{", fmt::format("after '{}'", section.text));
    const std::size_t inside = cursor_.open_blocks();
    while (!cursor_.at("}")) {
      cursor_.begin_statement();
      pair_begin_ = cursor_.peek().span.begin;
      pair_begins_line_ = cursor_.begins_line();
      equals_is_reported_ = false;
      try {
        if (cursor_.at_end()) cursor_.unexpected("'}'", "");
        if (at_section()) missing_brace(section.text, open);
        list.push_back(pair());
      } catch (const SyntaxError&) {
        skip_to_pair(inside);
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
  // After an error in a pair that begins a line, the next pair begins one too.
  bool at_next_pair() const {
    return at_pair() && cursor_.peek().span.begin > pair_begin_ && (cursor_.begins_line() || !pair_begins_line_);
  }
  void skip_to_pair(std::size_t inside) {
    cursor_.skip_until(
        [&] { return (cursor_.at("}") && cursor_.open_blocks() <= inside) || at_next_pair() || at_section(); });
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

  // After an error, the second side in the same line is not a pair of its own.
  Name first_side() {
    const bool left_first = at_left();
    try {
      return side();
    } catch (const SyntaxError&) {
      skip_to_pair(cursor_.open_blocks());
      if (!pair_begins_line_ && (left_first ? at_right() : at_left())) side();
      throw;
    }
  }

  [[noreturn]] void wrong_second_side(bool left_first) {
    const bool repeated = (at_left() || at_right()) && !cursor_.after_line_end();
    try {
      cursor_.unexpected(
          left_first ? "'target', 'right' or 'right_frame'" : "'base', 'left' or 'left_frame'",
          left_first ? "after the left frame" : "after the right frame");
    } catch (const SyntaxError&) {
      if (repeated) side();
      throw;
    }
  }

  // A missing '=' is reported once in a pair.
  Name side() {
    const Token word = cursor_.take();
    try {
      if (!equals_is_reported_ || cursor_.at("="))
        cursor_.expect("=", fmt::format("after '{}'", word.text));
      else
        cursor_.accept(":");
    } catch (const SyntaxError&) {
      equals_is_reported_ = true;
      cursor_.accept(":");
      if (!cursor_.at_name() || cursor_.after_line_end()) throw;  // else only the '=' is missing
    }
    return name("the name of a frame");
  }

  // `A <- B` means A_X_B, `A -> B` means B_X_A.
  void arrow(Pair& pair) {
    if (cursor_.at(",")) {
      if (!cursor_.is_faulty_here())
        cursor_.error("unexpected-token", "unexpected ',' between pairs of frames").hint =
            "pairs are separated by blanks only";
      throw SyntaxError{};
    }
    if (cursor_.at_name() && cursor_.at("=", 1) && !suggest_keyword(cursor_.peek().text, {"base", "target"}).empty())
      cursor_.unexpected("'base' or 'target'", "");
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
