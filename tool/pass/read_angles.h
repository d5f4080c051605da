// Which sines and cosines of angles a program reads, statement by statement.
#pragma once

#include <vector>

#include "pass/angle_table.h"
#include "symbolic/program.h"

namespace robcogen::pass {

// Of a sine or cosine of an angle: the angle, and the sign that it has there.
struct Reading {
  int angle = 0;
  bool negative = false;
};

// Of each statement that is a sine or cosine of angles: a reading for each lane; else none.
using Readings = std::vector<std::vector<Reading>>;

// New angles get their numbers.
Readings read_angles(const symbolic::Program& program, AngleTable& angles);

// The first array of a role, and where its elements stand among all.
struct InputPlace {
  const symbolic::InputArray* array = nullptr;
  int begin = 0;
  int size() const { return array ? static_cast<int>(array->elements.size()) : 0; }
  bool contains(int element) const { return element >= begin && element < begin + size(); }
};

InputPlace place_of(const symbolic::Program& program, symbolic::Role role);

}  // namespace robcogen::pass
