// Names of frames, in the sections of a desired-transforms document.
#pragma once

#include <initializer_list>
#include <string_view>
#include <utility>

#include "language/common/cursor.h"
#include "language/desired/document.h"

namespace robcogen::language::desired {

inline const std::initializer_list<std::string_view> kSections = {"Frames", "Transforms", "Jacobians", "Contacts"};

class FrameParser {
 public:
  explicit FrameParser(Cursor cursor) : cursor_(std::move(cursor)) {}

  Cursor& cursor() { return cursor_; }

  // 'Contacts' is no reserved word: a frame may have this name.
  bool at_section_word() const { return cursor_.at_any(kSections); }
  bool at_section() const { return at_section_word() && cursor_.at("{", 1); }
  // 'left' and 'right' are usual names of limbs: in their place they are no keywords.
  bool at_side() const { return cursor_.at_any({"left", "right"}); }
  bool at_instance() const { return (cursor_.at_name() || at_side()) && cursor_.at(".", 1); }
  // 'for' and 'in' are no reserved words either: frames may have these names.
  bool at_loop() const { return cursor_.at("for") && cursor_.at_name(1) && cursor_.at("in", 2); }

  Name name(std::string_view what);
  // Of a part.
  Name instance();
  // `foot`, or `leg.foot`.
  Name frame(std::string_view what = "the name of a frame");

 protected:
  Cursor cursor_;
  int loop_ = Name::kNoLoop;  // the present one
};

}  // namespace robcogen::language::desired
