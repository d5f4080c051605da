#include <fmt/format.h>

#include "language/common/content.h"
#include "language/transforms/document.h"

namespace robcogen::language::transforms {
namespace {

// After an error in a transform, the parser skips to the next one.
class Parser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), cursor_(tokenize_document(source_, diagnostics), keywords(), diagnostics) {
    document_.source = source_;
  }

  Document run() {
    try {
      document_.header = parse_frames_header(cursor_, {"TransformedFramePos", "MovedFramePos"});
      position();
      transforms();
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

  void position() {
    try {
      cursor_.begin_statement();
      if (!cursor_.at_any({"TransformedFramePos", "MovedFramePos"})) missing_position();
      const Token word = cursor_.take();
      document_.position_comments = cursor_.comments_before(word.span.begin);
      cursor_.expect("=", fmt::format("after '{}'", word.text));
      if (!cursor_.at_any({"left", "right"})) cursor_.unexpected("'left' or 'right'", "after '='");
      document_.position = cursor_.take().text == "left" ? MovedFramePosition::left : MovedFramePosition::right;
    } catch (const SyntaxError&) {
      cursor_.skip_until([&] { return at_transform(); });
    }
  }

  // At a transform, the line is missing; another word may be its misspelt keyword.
  [[noreturn]] void missing_position() {
    if (!at_transform())
      cursor_.unexpected("'Frames', 'Params', 'MovedFramePos' or 'TransformedFramePos'", "in the header");
    cursor_
        .error(
            "missing-position",
            "the line 'MovedFramePos = right' or 'MovedFramePos = left' is missing before the first transform")
        .hint =
        "right: Rx(a) maps coordinates of the frame rotated by +a to the original frame, the usual rotation matrix; "
        "left: the inverse";
    throw SyntaxError{};
  }

  bool at_transform() const { return cursor_.at("{") && cursor_.at("}", 2) && cursor_.at("_X_", 3); }

  // To the next transform, or to a line that may be a faulty one.
  void skip_to_transform() {
    cursor_.skip_until([&] { return at_transform() || (cursor_.at("{") && cursor_.begins_line()); });
  }

  void transforms() {
    while (!cursor_.at_end()) {
      try {
        document_.transforms.push_back(transform());
      } catch (const SyntaxError&) {
        // The token that begins the faulty transform does not begin another one.
        if (!cursor_.at_end() && cursor_.peek().span.begin == begin_) cursor_.take();
        skip_to_transform();
      }
    }
  }

  Name frame() {
    cursor_.expect("{", "before the name of a frame");
    const Token token = cursor_.expect_name("the name of a frame");
    cursor_.expect("}", "after the name of a frame");
    return {std::string(token.text), token.span};
  }

  Transform transform() {
    Transform transform;
    begin_ = cursor_.peek().span.begin;
    cursor_.begin_statement();
    transform.comments = cursor_.comments_before(begin_);
    transform.left = frame();
    cursor_.expect("_X_", "between two frames");
    transform.right = frame();
    cursor_.expect("=", "after two frames");
    transform.primitives = parse_steps(cursor_, primitive_words());
    transform.name = parse_user_name(cursor_);
    transform.span = {begin_, cursor_.previous().span.end};
    const bool begins_faulty_transform = cursor_.at("{") && cursor_.begins_line();
    if (!cursor_.at_end() && !at_transform() && !begins_faulty_transform)
      unexpected_after_steps(cursor_, primitive_words(), "a transform", "the next transform");
    return transform;
  }

  std::size_t begin_ = 0;  // of the present transform
};

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
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::transforms
