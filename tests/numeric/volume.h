// The number of random robots and states in property tests: few enough for every build, more on demand.
#pragma once

#include <cstdlib>

#if defined(__has_feature)
#define ROBCOGEN_SANITIZED __has_feature(address_sanitizer)
#elif defined(__SANITIZE_ADDRESS__)
#define ROBCOGEN_SANITIZED 1
#else
#define ROBCOGEN_SANITIZED 0
#endif

namespace robcogen::numeric {

// Returns the environment variable `name` as a positive number, or the default.
inline int volume(const char* name, int default_value) {
  const char* text = std::getenv(name);
  const int number = text == nullptr ? 0 : std::atoi(text);
  return number > 0 ? number : default_value;
}

// With sanitizers a run takes ten times as long, and looks for faults other than wrong numbers.
inline int robot_count() {
  return volume("ROBCOGEN_TEST_ROBOTS", ROBCOGEN_SANITIZED ? 100 : 250);
}
inline int state_count() {
  return volume("ROBCOGEN_TEST_STATES", 1);
}

}  // namespace robcogen::numeric
