#include "language/desired/parse_pair.h"

#include <fmt/format.h>

#include "language/desired/parse_loop.h"

namespace robcogen::language::desired {

bool PairParser::at_pair() const {
  const std::size_t behind = at_instance(cursor_) && cursor_.at_name(2) ? 3 : 1;
  return at_left() || at_right() || at_loop(cursor_) ||
         ((cursor_.at_name() || behind == 3) && (cursor_.at("->", behind) || cursor_.at("<-", behind)));
}

// After an error in a pair that begins a line, the next pair must begin a line too.
bool PairParser::at_next_pair() const {
  return at_pair() && cursor_.peek().span.begin > begin_ && (cursor_.begins_line() || !begins_line_);
}

void PairParser::skip_to_next(std::size_t open_blocks) {
  cursor_.skip_until([&] {
    return (cursor_.at("}") && cursor_.open_blocks() <= open_blocks) || at_next_pair() || at_section(cursor_);
  });
}

Pair PairParser::read() {
  Pair pair;
  if (at_left() || at_right()) {
    sides(pair);
  } else {
    arrow(pair);
  }
  pair.span = {begin_, cursor_.previous().span.end};
  return pair;
}

void PairParser::sides(Pair& pair) {
  const bool left_first = at_left();
  const Name first = first_side();
  cursor_.accept(",");
  if (left_first ? !at_right() : !at_left()) wrong_second_side(left_first);
  const Name second = side();
  pair.left = left_first ? first : second;
  pair.right = left_first ? second : first;
}

// After an error, the second side on the same line is not taken for another pair.
Name PairParser::first_side() {
  const bool left_first = at_left();
  try {
    return side();
  } catch (const SyntaxError&) {
    skip_to_next(cursor_.open_blocks());
    if (!begins_line_ && (left_first ? at_right() : at_left())) side();
    throw;
  }
}

void PairParser::wrong_second_side(bool left_first) {
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

// A missing '=' is reported once per pair.
Name PairParser::side() {
  const Token word = cursor_.take();
  try {
    if (!equals_is_reported_ || cursor_.at("="))
      cursor_.expect("=", fmt::format("after '{}'", word.text));
    else
      cursor_.accept(":");
  } catch (const SyntaxError&) {
    equals_is_reported_ = true;
    cursor_.accept(":");
    if (!cursor_.at_name() || cursor_.after_line_end()) throw;  // otherwise only the '=' is missing
  }
  return read_frame(cursor_, loop_);
}

// `A <- B` means A_X_B, `A -> B` means B_X_A.
void PairParser::arrow(Pair& pair) {
  if (cursor_.at(",")) {
    if (!cursor_.is_faulty_here())
      cursor_.error("unexpected-token", "unexpected ',' between pairs of frames").hint =
          "pairs are separated by blanks only";
    throw SyntaxError{};
  }
  if (cursor_.at_name() && cursor_.at("=", 1) && !suggest_keyword(cursor_.peek().text, {"base", "target"}).empty())
    cursor_.unexpected("'base' or 'target'", "");
  const Name first = read_frame(cursor_, loop_, "a pair of frames");
  if (!cursor_.at_any({"->", "<-"})) cursor_.unexpected("'->' or '<-'", fmt::format("after '{}'", first.text));
  const bool to_first = cursor_.take().text == "<-";
  const Name second = read_frame(cursor_, loop_);
  pair.left = to_first ? first : second;
  pair.right = to_first ? second : first;
}

}  // namespace robcogen::language::desired
