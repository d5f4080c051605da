// Completion of the command line in shells, derived from its description.
#pragma once

#include <string>
#include <vector>

#include "command/description.h"

namespace robcogen::command {

// The shells for which there is a script.
const std::vector<std::string>& shells();

// A script for one of these shells. It completes subcommands, options, and the values of options that have a choice.
std::string completions(const ProgramDescription& program, const std::string& shell);

}  // namespace robcogen::command
