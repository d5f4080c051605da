#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "language/common/content.h"
#include "language/desired/document.h"
#include "language/desired/frame_parser.h"
#include "language/desired/keywords.h"
#include "language/desired/parse_pair.h"

namespace robcogen::language::desired {
namespace {

// After an error in a section or a pair, the parser skips to the next one, or to the end of the block.
class Parser : private FrameParser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : FrameParser(Cursor(tokenize_document(source, diagnostics), keywords(), diagnostics)),
        source_(std::move(source)) {
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
  Document document_;
  std::vector<Token> found_;  // the words that begin sections
  bool may_have_skipped_section_ = false;
  bool is_in_braces_ = false;  // all of the sections, which is an error

  void header() {
    try {
      if (!cursor_.at_any({"Robot", "Model"}))
        cursor_.unexpected("'Robot' or 'Model'", "at the beginning of a desired-transforms document");
      cursor_.take();
      document_.robot = name("the name of the robot");
      brace_around_sections();
    } catch (const SyntaxError&) {
      cursor_.skip_until([&] { return at_section(); });
      if (cursor_.at_end()) throw;
    }
  }

  // As around the elements of a robot document.
  void brace_around_sections() {
    const auto next = [&](std::string_view word) { return cursor_.at(word, 1); };
    if (!cursor_.at("{") || std::none_of(kSections.begin(), kSections.end(), next)) return;
    cursor_.error("unexpected-token", "unexpected '{' after the name of the robot").hint =
        "the sections follow the name, without braces around them";
    cursor_.take();
    is_in_braces_ = true;
  }

  void sections() {
    while (!cursor_.at_end()) {
      cursor_.begin_statement();
      try {
        if (is_in_braces_ && cursor_.accept("}")) continue;
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

  [[noreturn]] void missing_brace(std::string_view section, const Token& open) {
    cursor_
        .error(
            "missing-brace",
            fmt::format("expected '}}' at the end of '{}', found {}", section, describe(cursor_.peek())))
        .notes.push_back({cursor_.place(open.span), "opened here"});
    throw SyntaxError{};
  }

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
      PairParser pair(*this);
      try {
        if (cursor_.at_end()) cursor_.unexpected("'}'", "");
        if (at_section()) missing_brace(section.text, open);
        if (at_loop())
          loop("a pair of frames", [&](const Token& inner) { pairs(section, inner, list); });
        else
          list.push_back(pair.read());
      } catch (const SyntaxError&) {
        pair.skip_to_next(inside);
        if (cursor_.at_end() || at_section()) throw;
      }
    }
    cursor_.take();
  }
};

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::desired
