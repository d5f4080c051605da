// The manual page of the command line, from its own description.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace robcogen::command {

// robcogen.1, in the macros man(7).
std::string manual(const CLI::App& application);

}  // namespace robcogen::command
