// Completion of the command line in shells, derived from its own description.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace robcogen::command {

// The shells for which there is a script.
const std::vector<std::string>& shells();

// A script for one of these shells. It completes subcommands, options, and the values of options that have a choice.
std::string completions(const CLI::App& application, const std::string& shell);

}  // namespace robcogen::command
