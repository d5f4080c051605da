// Parses a pair of frames in `Transforms` or `Jacobians`: `base = A, target = B`, `A <- B` or `A -> B`.
#pragma once

#include <cstddef>

#include "language/desired/parse_frame.h"

namespace robcogen::language::desired {

// Parses the pair that begins at the cursor; `loop` is the enclosing loop.
class PairParser {
 public:
  PairParser(Cursor& cursor, int loop)
      : cursor_(cursor), loop_(loop), begin_(cursor.peek().span.begin), begins_line_(cursor.begins_line()) {}

  Pair read();
  // After an error, skips to the next pair, or to the end of the block in which this many blocks are open.
  void skip_to_next(std::size_t open_blocks);

 private:
  Cursor& cursor_;
  const int loop_;
  const std::size_t begin_;
  const bool begins_line_;
  bool equals_is_reported_ = false;

  bool at_left() const { return cursor_.at_any({"base", "left", "left_frame"}) && !at_instance(cursor_); }
  bool at_right() const { return cursor_.at_any({"target", "right", "right_frame"}) && !at_instance(cursor_); }
  bool at_pair() const;
  bool at_next_pair() const;
  void sides(Pair& pair);
  Name first_side();
  [[noreturn]] void wrong_second_side(bool left_first);
  Name side();
  void arrow(Pair& pair);
};

}  // namespace robcogen::language::desired
