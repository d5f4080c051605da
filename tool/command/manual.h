// The manual page of the command line, derived from its own description.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace robcogen::command {

// The page robcogen.1, in man(7) macros.
std::string manual(const CLI::App& application);

}  // namespace robcogen::command
