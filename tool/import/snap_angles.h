// Finds angles that are multiples of PI/12 up to the rounding of their decimals.
#pragma once

#include <string>

#include "support/diagnostics.h"
#include "support/number.h"

namespace robcogen::import {

// Treats angles that are within 1e-6 of a multiple of PI/12 and not exactly zero. If it snaps, they become that
// multiple, with a note on each; otherwise one note counts them.
class AngleSnapper {
 public:
  AngleSnapper(bool snaps, Diagnostics& diagnostics) : snaps_(snaps), diagnostics_(diagnostics) {}

  // `name` and `owner` are for messages: `roll` of `the origin of joint 'hip'`.
  void treat(Number& angle, const Place& place, const char* name, const std::string& owner);

  // Adds the note that counts the angles.
  void note_count() const;

 private:
  bool snaps_;
  Diagnostics& diagnostics_;
  int count_ = 0;
  double largest_change_ = 0.0;  // rad
  Place first_;
};

}  // namespace robcogen::import
