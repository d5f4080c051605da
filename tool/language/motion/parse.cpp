#include <fmt/format.h>

#include "language/common/content.h"
#include "language/motion/document.h"

namespace robcogen::language::motion {
namespace {

bool at_motion(const Cursor& cursor) {
  return cursor.at_name() && cursor.at("->", 1);
}

// If the cursor is at a motion, the line is missing; another word may be a misspelt keyword of it.
[[noreturn]] void report_missing_convention(Cursor& cursor) {
  if (!at_motion(cursor)) cursor.unexpected("'Frames', 'Params' or 'Convention'", "in the header");
  cursor
      .error(
          "missing-convention",
          "the line 'Convention = local' or 'Convention = fixed' is missing before the first motion")
      .hint =
      "local: each step is about the axes of the frame reached so far; fixed: axes stay parallel to the first frame";
  throw SyntaxError{};
}

void read_convention(Cursor& cursor, Document& document) {
  try {
    cursor.begin_statement();
    if (!cursor.at("Convention")) report_missing_convention(cursor);
    const Token word = cursor.take();
    document.convention_comments = cursor.comments_before(word.span.begin);
    cursor.expect("=", "after 'Convention'");
    if (!cursor.at_any({"local", "fixed", "currentFrame", "fixedFrame"}))
      cursor.unexpected("'local', 'fixed', 'currentFrame' or 'fixedFrame'", "after '='");
    const Token value = cursor.take();
    const bool is_local = value.text == "local" || value.text == "currentFrame";
    document.convention = is_local ? Convention::local : Convention::fixed;
  } catch (const SyntaxError&) {
    cursor.skip_until([&] { return at_motion(cursor); });
  }
}

Name read_frame(Cursor& cursor) {
  const Token token = cursor.expect_name("the name of a frame");
  return {std::string(token.text), token.span};
}

Motion read_motion(Cursor& cursor) {
  Motion motion;
  const std::size_t begin = cursor.peek().span.begin;
  cursor.begin_statement();
  motion.comments = cursor.comments_before(begin);
  motion.from = read_frame(cursor);
  cursor.expect("->", fmt::format("after '{}'", motion.from.text));
  motion.to = read_frame(cursor);
  cursor.expect(":", fmt::format("after '{}'", motion.to.text));
  motion.steps = parse_steps(cursor, step_words());
  motion.name = parse_user_name(cursor);
  motion.span = {begin, cursor.previous().span.end};
  const bool begins_faulty_motion = cursor.at_name() && cursor.begins_line() && !cursor.at("(", 1);
  if (!cursor.at_end() && !at_motion(cursor) && !begins_faulty_motion)
    unexpected_after_steps(cursor, step_words(), "a motion", "the next motion");
  return motion;
}

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
  Document document;
  document.source = source;
  Cursor cursor(tokenize_document(source, diagnostics), keywords(), diagnostics);
  try {
    document.header = parse_frames_header(cursor, {"Convention"});
    read_convention(cursor, document);
    const auto may_begin = [](const Cursor& c) { return c.at_name(); };
    document.motions = parse_statements(cursor, at_motion, may_begin, read_motion);
  } catch (const SyntaxError&) {
    // reported; the file ends here
  }
  document.trailing_comments = cursor.comments_before(source->text().size() + 1);
  return document;
}

}  // namespace robcogen::language::motion
