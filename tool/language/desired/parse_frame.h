// Names of frames and of instances of parts, in the sections of a desired-transforms document.
#pragma once

#include <initializer_list>
#include <string_view>

#include "language/common/cursor.h"
#include "language/desired/document.h"

namespace robcogen::language::desired {

inline const std::initializer_list<std::string_view> kSections = {"Frames", "Transforms", "Jacobians", "Contacts"};

// 'Contacts' is not a reserved word: a frame may have this name.
bool at_section_word(const Cursor& cursor);
bool at_section(const Cursor& cursor);
// At the name of an instance, and its point.
bool at_instance(const Cursor& cursor);

Name read_name(Cursor& cursor, std::string_view what);
// Of a part.
Name read_instance(Cursor& cursor);
// `foot`, or `leg.foot`; `loop` is the one that it stands in.
Name read_frame(Cursor& cursor, int loop, std::string_view what = "the name of a frame");

}  // namespace robcogen::language::desired
