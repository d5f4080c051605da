#include <fmt/format.h>

#include "language/common/parser.h"
#include "language/desired/document.h"
#include "language/desired/keywords.h"

namespace robcogen::language::desired {
namespace {

class Parser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), cursor_(tokenize(source_, diagnostics), keywords(), diagnostics) {
    document_.source = source_;
  }

  Document run() {
    try {
      header();
      frames();
      pairs("Transforms", document_.transforms);
      if (cursor_.at("Jacobians")) pairs("Jacobians", document_.jacobians);
      if (!cursor_.at_end()) after_end();
    } catch (const SyntaxError&) {
      // reported; nothing further can be made of the file
    }
    document_.comments = cursor_.comments_before(source_->text().size() + 1);
    return std::move(document_);
  }

 private:
  std::shared_ptr<const Source> source_;
  Cursor cursor_;
  Document document_;

  Name name(std::string_view what) {
    if (cursor_.at("$")) template_fault();
    const Token token = cursor_.expect_name(what);
    return {token.text, token.span};
  }

  [[noreturn]] void template_fault() {
    cursor_.error("template", "'${…}' is a placeholder, not a name").hint =
        "this is a template: fill it in before it is read";
    throw SyntaxError{};
  }

  void header() {
    if (cursor_.at_end()) {
      cursor_.error("empty-document", "the document is empty; expected 'Robot <name> Frames { … } Transforms { … }'");
      throw SyntaxError{};
    }
    if (!cursor_.accept("Robot") && !cursor_.accept("Model"))
      cursor_.unexpected("'Robot' or 'Model'", "at the beginning of a desired-transforms document");
    document_.robot = name("the name of the robot");
  }

  void frames() {
    cursor_.expect("Frames", "after the name of the robot");
    cursor_.expect("{", "after 'Frames'");
    while (!cursor_.accept("}")) {
      cursor_.accept(",");
      if (cursor_.at("}")) cursor_.unexpected("the name of a frame", "after ','");
      document_.frames.push_back(name("the name of a frame"));
    }
  }

  // The dialect of 2018 asks for quantities by query: `FK name { … }`, `IKpos …`.
  bool at_query() const { return cursor_.at_any({"FK", "IKpos", "IKor", "IKvel", "Jac"}); }

  void after_end() {
    if (at_query()) query_fault();
    cursor_.error("text-after-end", fmt::format("{} stands after the end of the document", describe(cursor_.peek())));
  }

  [[noreturn]] void query_fault() {
    cursor_
        .error(
            "query-dialect",
            fmt::format("'{}' belongs to the query dialect of 2018, which is not supported", cursor_.peek().text))
        .hint = "list pairs of frames in 'Transforms { … }' and 'Jacobians { … }'";
    throw SyntaxError{};
  }

  void pairs(std::string_view section, std::vector<Pair>& list) {
    if (at_query()) query_fault();
    cursor_.expect(section, "in a desired-transforms document");
    cursor_.expect("{", fmt::format("after '{}'", section));
    while (!cursor_.accept("}")) {
      try {
        list.push_back(pair());
      } catch (const SyntaxError&) {
        // The next pair begins at a keyword, or ends at the brace.
        while (!cursor_.at_end() && !cursor_.at("}") && !cursor_.at_keyword()) cursor_.take();
        if (cursor_.at_end()) throw;
        if (!cursor_.at("}") && !at_side()) throw;
      }
    }
  }

  bool at_left(std::size_t ahead = 0) const {
    return cursor_.at("base", ahead) || cursor_.at("left", ahead) || cursor_.at("left_frame", ahead);
  }
  bool at_right(std::size_t ahead = 0) const {
    return cursor_.at("target", ahead) || cursor_.at("right", ahead) || cursor_.at("right_frame", ahead);
  }
  bool at_side() const { return at_left() || at_right(); }

  Pair pair() {
    if (cursor_.at("$")) template_fault();
    Pair pair;
    pair.span.begin = cursor_.peek().span.begin;
    if (at_left()) {
      pair.left = side();
      cursor_.accept(",");
      if (!at_right()) cursor_.unexpected("'target', 'right' or 'right_frame'", "after the left frame");
      pair.right = side();
    } else if (at_right()) {
      pair.right = side();
      cursor_.accept(",");
      if (!at_left()) cursor_.unexpected("'base', 'left' or 'left_frame'", "after the right frame");
      pair.left = side();
    } else {
      arrow(pair);
    }
    pair.span.end = std::max(pair.left.span.end, pair.right.span.end);
    return pair;
  }

  Name side() {
    const Token word = cursor_.take();
    cursor_.expect("=", fmt::format("after '{}'", word.text));
    return name("the name of a frame");
  }

  // `A <- B` means A_X_B, `A -> B` means B_X_A.
  void arrow(Pair& pair) {
    Name first = name("a pair of frames");
    const bool to_left = cursor_.at("<-");
    if (!to_left && !cursor_.at("->")) cursor_.unexpected("'->' or '<-'", fmt::format("after '{}'", first.text));
    cursor_.take();
    Name second = name("the name of a frame");
    pair.left = to_left ? first : second;
    pair.right = to_left ? second : first;
  }
};

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::desired
