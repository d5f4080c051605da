// How a subcommand ends (driver/failure.h).
#pragma once

#include "driver/failure.h"

namespace robcogen::command {

using driver::Failure;
using driver::Status;
using enum driver::Status;

// `message`, and a line of its own for the hint when there is one.
std::string with_hint(const std::string& message, const std::string& hint);

}  // namespace robcogen::command
