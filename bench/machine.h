// Queries of the report to the operating system.
#pragma once

#include <optional>
#include <string>

namespace robcogen::bench {

// A word of a command line of the shell.
std::string quoted(const std::string& text);

// Standard output of a command of the shell; nullopt when it could not run or failed.
std::optional<std::string> output_of(const std::string& command);

// Ties this process and those that it starts to one processor, the last that it may use, as interrupts mostly go to the
// first. Its number, or nullopt where the system has no such thing.
std::optional<int> pin_to_one_processor();

// As the system calls it; empty when it does not say.
std::string processor_name();

}  // namespace robcogen::bench
