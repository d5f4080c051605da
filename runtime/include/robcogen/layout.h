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

// clang packs members that ask for an alignment of their own, as those of Eigen do; gcc does not.
struct WithAlignedMember {
  char first;
  alignas(16) char second;
};

static_assert(
    offsetof(WithAlignedMember, second) == 16,
    "The matrices in structures of results need their alignment: compile this file without -fpack-struct, and include the "
    "header outside of #pragma pack.");

}  // namespace robcogen::layout
