// Queries to the operating system, for the report.
#pragma once

#include <optional>
#include <string>

namespace robcogen::bench {

// The text quoted as one word of a shell command.
std::string quoted(const std::string& text);

// Standard output of a shell command; nullopt if it could not run or failed.
std::optional<std::string> output_of(const std::string& command);

// Pins this process and those that it starts to one processor, the last that it may use, because interrupts mostly go
// to the first. Returns its number, or nullopt if the system does not support this.
std::optional<int> pin_to_one_processor();

// The system's name for the processor; empty if it is unknown.
std::string processor_name();

}  // namespace robcogen::bench
