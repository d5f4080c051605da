// How the program ends.
#pragma once

#include <string>

namespace robcogen::command {

// Exit statuses of the program.
enum Status { ok = 0, wrong_input = 1, wrong_usage = 2, internal_fault = 3 };

// Thrown by subcommands for usage and input/output faults that no diagnostic covers; main prints and exits with it.
struct Failure {
  Status status;
  std::string message;
};

}  // namespace robcogen::command
