// The command line: which subcommand runs, with which options.
#pragma once

#include <functional>

#include "command/status.h"

namespace robcogen::command {

// What the arguments ask for, ready to run; for --help and --version, what prints these. A Failure that says what is
// wrong with the arguments and what to write instead.
std::function<Status()> parse_command_line(int argc, char** argv);

}  // namespace robcogen::command
