// Parses names of frames and of instances of parts, in the sections of a desired-transforms document.
#pragma once

#include <initializer_list>
#include <string_view>

#include "language/common/cursor.h"
#include "language/desired/document.h"

namespace robcogen::language::desired {

const std::initializer_list<std::string_view> kSections = {"Frames",   "Transforms",        "Jacobians",
                                                           "Contacts", "InverseKinematics", "Functions"};

// 'Contacts', 'InverseKinematics' and 'Functions' are not reserved words: frames may have these names.
bool at_section_word(const Cursor& cursor);
bool at_section(const Cursor& cursor);
// Whether the cursor is at the name of an instance, followed by a point.
bool at_instance(const Cursor& cursor);

Name read_name(Cursor& cursor, std::string_view what);
// Parses the name of an instance of a part.
Name read_instance(Cursor& cursor);
// Parses `foot` or `leg.foot`; `loop` is the enclosing loop.
Name read_frame(Cursor& cursor, int loop, std::string_view what = "the name of a frame");

}  // namespace robcogen::language::desired
