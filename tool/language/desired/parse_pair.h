// A pair of frames of `Transforms` or `Jacobians`: `base = A, target = B`, `A <- B` or `A -> B`.
#pragma once

#include <cstddef>

#include "language/desired/frame_parser.h"

namespace robcogen::language::desired {

// From where the pair begins on.
class PairParser {
 public:
  explicit PairParser(FrameParser& parser)
      : parser_(parser),
        cursor_(parser.cursor()),
        begin_(cursor_.peek().span.begin),
        begins_line_(cursor_.begins_line()) {}

  Pair read();
  // After an error: to the next pair, or to the end of the block that was open with so many others.
  void skip_to_next(std::size_t open_blocks);

 private:
  FrameParser& parser_;
  Cursor& cursor_;
  const std::size_t begin_;
  const bool begins_line_;
  bool equals_is_reported_ = false;

  bool at_left() const { return cursor_.at_any({"base", "left", "left_frame"}) && !parser_.at_instance(); }
  bool at_right() const { return cursor_.at_any({"target", "right", "right_frame"}) && !parser_.at_instance(); }
  bool at_pair() const;
  bool at_next_pair() const;
  void sides(Pair& pair);
  Name first_side();
  [[noreturn]] void wrong_second_side(bool left_first);
  Name side();
  void arrow(Pair& pair);
};

}  // namespace robcogen::language::desired
