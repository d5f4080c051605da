// The number of random robots and states in property tests: few enough for every build, more on demand.
#pragma once

#include <cstdlib>

namespace robcogen::numeric {

// Returns the environment variable `name` as a positive number, or the default.
inline int volume(const char* name, int default_value) {
  const char* text = std::getenv(name);
  const int number = text == nullptr ? 0 : std::atoi(text);
  return number > 0 ? number : default_value;
}

inline int robot_count() {
  return volume("ROBCOGEN_TEST_ROBOTS", 120);
}
inline int state_count() {
  return volume("ROBCOGEN_TEST_STATES", 1);
}

}  // namespace robcogen::numeric
