// Which sines and cosines of angles a program reads, statement by statement.
#pragma once

#include <vector>

#include "pass/angle_table.h"
#include "symbolic/program.h"

namespace robcogen::pass {

// The angle that a sine or cosine reads, and its sign there.
struct Reading {
  int angle = 0;
  bool negative = false;
};

// By statement: a reading for each lane if it is a sine or cosine of angles, otherwise none.
using Readings = std::vector<std::vector<Reading>>;

// The angles that a program reads. New angles are added to the table.
Readings read_angles(const symbolic::Program& program, AngleTable& angles);

// The first input array with a role, and the flat index of its first element.
struct InputPlace {
  const symbolic::InputArray* array = nullptr;
  int begin = 0;
  int size() const { return array ? static_cast<int>(array->elements.size()) : 0; }
  bool contains(int element) const { return element >= begin && element < begin + size(); }
};

InputPlace place_of(const symbolic::Program& program, symbolic::Role role);

}  // namespace robcogen::pass
