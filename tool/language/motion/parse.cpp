#include <fmt/format.h>

#include "language/common/content.h"
#include "language/motion/document.h"

namespace robcogen::language::motion {
namespace {

// After an error in a motion, the parser skips to the next one.
class Parser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), cursor_(tokenize_document(source_, diagnostics), keywords(), diagnostics) {
    document_.source = source_;
  }

  Document run() {
    try {
      document_.header = parse_frames_header(cursor_, {"Convention"});
      convention();
      motions();
    } catch (const SyntaxError&) {
      // reported; the file ends here
    }
    document_.trailing_comments = cursor_.comments_before(source_->text().size() + 1);
    return std::move(document_);
  }

 private:
  std::shared_ptr<const Source> source_;
  Cursor cursor_;
  Document document_;

  void convention() {
    try {
      cursor_.begin_statement();
      if (!cursor_.at("Convention")) missing_convention();
      const Token word = cursor_.take();
      document_.convention_comments = cursor_.comments_before(word.span.begin);
      cursor_.expect("=", "after 'Convention'");
      if (!cursor_.at_any({"local", "fixed", "currentFrame", "fixedFrame"}))
        cursor_.unexpected("'local', 'fixed', 'currentFrame' or 'fixedFrame'", "after '='");
      const Token value = cursor_.take();
      const bool is_local = value.text == "local" || value.text == "currentFrame";
      document_.convention = is_local ? Convention::local : Convention::fixed;
    } catch (const SyntaxError&) {
      cursor_.skip_until([&] { return at_motion(); });
    }
  }

  // At a motion, the line is missing; another word may be its misspelt keyword.
  [[noreturn]] void missing_convention() {
    if (!at_motion()) cursor_.unexpected("'Frames', 'Params' or 'Convention'", "in the header");
    cursor_
        .error(
            "missing-convention",
            "the line 'Convention = local' or 'Convention = fixed' is missing before the first motion")
        .hint =
        "local: each step is about the axes of the frame reached so far; fixed: axes stay parallel to the first frame";
    throw SyntaxError{};
  }

  bool at_motion() const { return cursor_.at_name() && cursor_.at("->", 1); }

  // To the next motion, or to a line that may be a faulty one.
  void skip_to_motion() {
    cursor_.skip_until([&] { return at_motion() || (cursor_.at_name() && cursor_.begins_line()); });
  }

  void motions() {
    while (!cursor_.at_end()) {
      try {
        document_.motions.push_back(motion());
      } catch (const SyntaxError&) {
        // The token that begins the faulty motion does not begin another one.
        if (!cursor_.at_end() && cursor_.peek().span.begin == begin_) cursor_.take();
        skip_to_motion();
      }
    }
  }

  Name frame() {
    const Token token = cursor_.expect_name("the name of a frame");
    return {std::string(token.text), token.span};
  }

  Motion motion() {
    Motion motion;
    begin_ = cursor_.peek().span.begin;
    cursor_.begin_statement();
    motion.comments = cursor_.comments_before(begin_);
    motion.from = frame();
    cursor_.expect("->", fmt::format("after '{}'", motion.from.text));
    motion.to = frame();
    cursor_.expect(":", fmt::format("after '{}'", motion.to.text));
    motion.steps = parse_steps(cursor_, step_words());
    motion.name = parse_user_name(cursor_);
    motion.span = {begin_, cursor_.previous().span.end};
    const bool begins_faulty_motion = cursor_.at_name() && cursor_.begins_line() && !cursor_.at("(", 1);
    if (!cursor_.at_end() && !at_motion() && !begins_faulty_motion)
      unexpected_after_steps(cursor_, step_words(), "a motion", "the next motion");
    return motion;
  }

  std::size_t begin_ = 0;  // of the present motion
};

}  // namespace

const std::vector<std::string>& step_words() {
  static const std::vector<std::string> words = {"trx", "try", "trz", "rotx", "roty", "rotz"};
  return words;
}

const std::vector<std::string>& keywords() {
  static const std::vector<std::string> words = {"Model", "Frames",       "Params",     "Convention", "local",
                                                 "fixed", "currentFrame", "fixedFrame", "trx",        "try",
                                                 "trz",   "rotx",         "roty",       "rotz"};
  return words;
}

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::motion
