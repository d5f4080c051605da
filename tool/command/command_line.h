// The command line: which subcommand runs, and with which options.
#pragma once

#include <functional>

#include "command/status.h"

namespace robcogen::command {

// Parses the arguments and returns the action that they ask for, ready to run. For --help and --version, the action
// prints the answer. Throws a Failure that says what is wrong with the arguments and what to write instead.
std::function<Status()> parse_command_line(int argc, char** argv);

}  // namespace robcogen::command
