// How many random robots and states the property tests take: few enough for every build, more on demand.
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

// The environment variable `name` as a positive number, else the default.
inline int volume(const char* name, int default_value) {
  const char* text = std::getenv(name);
  const int number = text == nullptr ? 0 : std::atoi(text);
  return number > 0 ? number : default_value;
}

// Sanitizers make a run ten times as long, and look for other faults than numbers.
inline int robot_count() {
  return volume("ROBCOGEN_TEST_ROBOTS", ROBCOGEN_SANITIZED ? 200 : 2000);
}
inline int state_count() {
  return volume("ROBCOGEN_TEST_STATES", 1);
}

}  // namespace robcogen::numeric
