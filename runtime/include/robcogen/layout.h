// What a library and its users must agree on: how the compiler lays out the structures in the tables of a library.
//
// The library is compiled with options of its own, so this stops a build in which the user's options change them:
// -fpack-struct, or #pragma pack around an include.
#pragma once

#include <cstddef>

namespace robcogen::layout {

struct WithGap {
  char first;
  void* second;
};

static_assert(
    offsetof(WithGap, second) == alignof(void*),
    "The tables of a generated library have gaps between members: compile this file without -fpack-struct, and include "
    "the header outside of #pragma pack.");

}  // namespace robcogen::layout
