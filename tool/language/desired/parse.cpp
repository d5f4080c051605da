#include <fmt/format.h>

#include <algorithm>
#include <utility>

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
  int loop_ = Name::kNoLoop;  // the present one

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

  // 'left' and 'right' are usual names of limbs: in their place they are no keywords.
  bool at_side() const { return cursor_.at_any({"left", "right"}); }

  Name instance() {
    if (!at_side()) return name("the name of an instance of a part");
    const Token side = cursor_.take();
    return {std::string(side.text), side.span};
  }

  bool at_instance() const { return (cursor_.at_name() || at_side()) && cursor_.at(".", 1); }

  // `foot`, or `leg.foot`.
  Name frame(std::string_view what = "the name of a frame") {
    Name result = at_instance() ? instance() : name(what);
    result.loop = loop_;
    if (!cursor_.accept(".")) return result;
    result.instance = std::exchange(result.text, {});
    result.instance_span = result.span;
    const Name own = name(fmt::format("the name of a frame of '{}'", result.instance));
    result.text = own.text;
    result.span.end = own.span.end;
    return result;
  }

  // 'for' and 'in' are no reserved words either: frames may have these names.
  bool at_loop() const { return cursor_.at("for") && cursor_.at_name(1) && cursor_.at("in", 2); }

  // After an error, the body is read all the same.
  void instances(Loop& loop) {
    try {
      do loop.instances.push_back(instance());
      while (cursor_.accept(","));
      if (!cursor_.accept("}")) cursor_.unexpected("',' or '}'", "in the list of instances");
    } catch (const SyntaxError&) {
      cursor_.skip_until([&] { return cursor_.at_any({"}", "->", "<-"}) || at_section(); });
      if (!cursor_.accept("}") || !cursor_.at("{")) throw;
    }
  }

  // `for leg in { LF, RF } {`; reads the body, whose elements follow, by element(open).
  template <class Body>
  void loop(std::string_view element, const Body& body) {
    const Token word = cursor_.take();
    if (loop_ != Name::kNoLoop) {
      cursor_.error_at(word.span, "nested-loop", "a loop cannot stand in another one").hint =
          "write a loop for each instance of the outer one";
      throw SyntaxError{};
    }
    Loop loop;
    loop.variable = name("the name of a variable");
    cursor_.take();
    cursor_.expect("{", "after 'in'");
    instances(loop);
    const Token open = cursor_.expect("{", "after the list of instances");
    if (cursor_.at("}")) cursor_.unexpected(element, "in the loop");
    loop_ = static_cast<int>(document_.loops.size());
    document_.loops.push_back(std::move(loop));
    try {
      body(open);
    } catch (const SyntaxError&) {
      loop_ = Name::kNoLoop;
      throw;
    }
    loop_ = Name::kNoLoop;
  }

  // The names of a section; calls element() at each.
  template <class Element>
  void list(std::string_view section, const Element& element) {
    elements(section, cursor_.expect("{", fmt::format("after '{}'", section)), element);
  }

  template <class Element>
  void elements(std::string_view section, const Token& open, const Element& element) {
    while (!cursor_.at("}")) {
      cursor_.begin_statement();
      if (at_section()) missing_brace(section, open);
      if (cursor_.accept(",") && cursor_.at("}")) cursor_.unexpected("the name of a frame", "after ','");
      if (at_loop() && cursor_.at("{", 3)) {
        loop("the name of a frame", [&](const Token& inner) { elements(section, inner, element); });
        continue;
      }
      element();
      if (cursor_.at("-") || cursor_.at(".")) cursor_.unexpected("',' or '}'", "after the name of a frame");
    }
    cursor_.take();
  }

  void frames() {
    list("Frames", [&] { document_.frames.push_back(frame()); });
  }

  // `fr_foot`, `point fr_foot`, `surface fr_sole`.
  void contacts() {
    list("Contacts", [&] {
      const bool has_kind = cursor_.at_any({"point", "surface"}) &&
                            (cursor_.at_name(1) || cursor_.at("left", 1) || cursor_.at("right", 1));
      const bool is_surface = has_kind && cursor_.take().text == "surface";
      document_.contacts.push_back({frame(), is_surface});
    });
  }

  void pairs(const Token& section, std::vector<Pair>& list) {
    pairs(section, cursor_.expect("{", fmt::format("after '{}'", section.text)), list);
  }

  void pairs(const Token& section, const Token& open, std::vector<Pair>& list) {
    const std::size_t inside = cursor_.open_blocks();
    while (!cursor_.at("}")) {
      cursor_.begin_statement();
      pair_begin_ = cursor_.peek().span.begin;
      pair_begins_line_ = cursor_.begins_line();
      equals_is_reported_ = false;
      try {
        if (cursor_.at_end()) cursor_.unexpected("'}'", "");
        if (at_section()) missing_brace(section.text, open);
        if (at_loop())
          loop("a pair of frames", [&](const Token& inner) { pairs(section, inner, list); });
        else
          list.push_back(pair());
      } catch (const SyntaxError&) {
        skip_to_pair(inside);
        if (cursor_.at_end() || at_section()) throw;
      }
    }
    cursor_.take();
  }

  bool at_left() const { return cursor_.at_any({"base", "left", "left_frame"}) && !at_instance(); }
  bool at_right() const { return cursor_.at_any({"target", "right", "right_frame"}) && !at_instance(); }
  bool at_pair() const {
    const std::size_t behind = at_instance() && cursor_.at_name(2) ? 3 : 1;
    return at_left() || at_right() || at_loop() ||
           ((cursor_.at_name() || behind == 3) && (cursor_.at("->", behind) || cursor_.at("<-", behind)));
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
    return frame();
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
    const Name first = frame("a pair of frames");
    if (!cursor_.at_any({"->", "<-"})) cursor_.unexpected("'->' or '<-'", fmt::format("after '{}'", first.text));
    const bool to_first = cursor_.take().text == "<-";
    const Name second = frame();
    pair.left = to_first ? first : second;
    pair.right = to_first ? second : first;
  }
};

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::desired
