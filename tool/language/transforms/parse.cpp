#include <fmt/format.h>

#include "language/common/content.h"
#include "language/transforms/document.h"

namespace robcogen::language::transforms {
namespace {

bool at_transform(const Cursor& cursor) {
  return cursor.at("{") && cursor.at("}", 2) && cursor.at("_X_", 3);
}

// If the cursor is at a transform, the line is missing; another word may be a misspelt keyword of it.
[[noreturn]] void report_missing_position(Cursor& cursor) {
  if (!at_transform(cursor))
    cursor.unexpected("'Frames', 'Params', 'MovedFramePos' or 'TransformedFramePos'", "in the header");
  cursor
      .error(
          "missing-position",
          "the line 'MovedFramePos = right' or 'MovedFramePos = left' is missing before the first transform")
      .hint =
      "right: Rx(a) maps coordinates of the frame rotated by +a to the original frame, the usual rotation matrix; "
      "left: the inverse";
  throw SyntaxError{};
}

void read_position(Cursor& cursor, Document& document) {
  try {
    cursor.begin_statement();
    if (!cursor.at_any({"TransformedFramePos", "MovedFramePos"})) report_missing_position(cursor);
    const Token word = cursor.take();
    document.position_comments = cursor.comments_before(word.span.begin);
    cursor.expect("=", fmt::format("after '{}'", word.text));
    if (!cursor.at_any({"left", "right"})) cursor.unexpected("'left' or 'right'", "after '='");
    document.position = cursor.take().text == "left" ? MovedFramePosition::left : MovedFramePosition::right;
  } catch (const SyntaxError&) {
    cursor.skip_until([&] { return at_transform(cursor); });
  }
}

Name read_frame(Cursor& cursor) {
  cursor.expect("{", "before the name of a frame");
  const Token token = cursor.expect_name("the name of a frame");
  cursor.expect("}", "after the name of a frame");
  return {std::string(token.text), token.span};
}

Transform read_transform(Cursor& cursor) {
  Transform transform;
  const std::size_t begin = cursor.peek().span.begin;
  cursor.begin_statement();
  transform.comments = cursor.comments_before(begin);
  transform.left = read_frame(cursor);
  cursor.expect("_X_", "between two frames");
  transform.right = read_frame(cursor);
  cursor.expect("=", "after two frames");
  transform.primitives = parse_steps(cursor, primitive_words());
  transform.name = parse_user_name(cursor);
  transform.span = {begin, cursor.previous().span.end};
  const bool begins_faulty_transform = cursor.at("{") && cursor.begins_line();
  if (!cursor.at_end() && !at_transform(cursor) && !begins_faulty_transform)
    unexpected_after_steps(cursor, primitive_words(), "a transform", "the next transform");
  return transform;
}

}  // namespace

const std::vector<std::string>& primitive_words() {
  static const std::vector<std::string> words = {"Tx", "Ty", "Tz", "Rx", "Ry", "Rz"};
  return words;
}

const std::vector<std::string>& keywords() {
  static const std::vector<std::string> words = {
      "Model", "Frames", "Params", "TransformedFramePos", "MovedFramePos", "left", "right", "Tx", "Ty", "Tz", "Rx",
      "Ry",    "Rz",     "_X_"};
  return words;
}

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  Document document;
  document.source = source;
  Cursor cursor(tokenize_document(source, diagnostics), keywords(), diagnostics);
  try {
    document.header = parse_frames_header(cursor, {"TransformedFramePos", "MovedFramePos"});
    read_position(cursor, document);
    const auto may_begin = [](const Cursor& c) { return c.at("{"); };
    document.transforms = parse_statements(cursor, at_transform, may_begin, read_transform);
  } catch (const SyntaxError&) {
    // reported; the file ends here
  }
  document.trailing_comments = cursor.comments_before(source->text().size() + 1);
  return document;
}

}  // namespace robcogen::language::transforms
