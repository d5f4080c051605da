// Completion of the command line in shells, from its own description.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace robcogen::command {

// The shells that there are scripts for.
const std::vector<std::string>& shells();

// A script for one of them to read: subcommands, options, and the values of options that have a choice.
std::string completions(const CLI::App& application, const std::string& shell);

}  // namespace robcogen::command
