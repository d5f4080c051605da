// The manual page of the command line, derived from its description.
#pragma once

#include <string>

#include "command/description.h"

namespace robcogen::command {

// The page robcogen.1, in man(7) macros.
std::string manual(const ProgramDescription& program);

}  // namespace robcogen::command
