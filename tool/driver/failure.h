// Faults that end a run, and the exit statuses of the program.
#pragma once

#include <string>

namespace robcogen::driver {

// Exit statuses of the program.
enum Status { ok = 0, wrong_input = 1, wrong_usage = 2, internal_fault = 3 };

// Thrown for usage and input/output faults that no diagnostic covers; main prints and exits with it.
struct Failure {
  Status status;
  std::string message;
};

// The message, followed by the hint on a line of its own if there is one.
inline std::string with_hint(const std::string& message, const std::string& hint) {
  return hint.empty() ? message : message + "\nhint: " + hint;
}

}  // namespace robcogen::driver
