// How many random robots and states the property tests take: few enough for every build, more on demand.
#pragma once

#include <cstdlib>

namespace robcogen::numeric {

// The environment variable `name` as a positive number, else the default.
inline int volume(const char* name, int default_value) {
  const char* text = std::getenv(name);
  const int number = text == nullptr ? 0 : std::atoi(text);
  return number > 0 ? number : default_value;
}

inline int robot_count() {
  return volume("ROBCOGEN_TEST_ROBOTS", 2000);
}
inline int state_count() {
  return volume("ROBCOGEN_TEST_STATES", 1);
}

}  // namespace robcogen::numeric
