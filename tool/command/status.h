// How a subcommand ends (driver/failure.h).
#pragma once

#include "driver/failure.h"

namespace robcogen::command {

using driver::Failure;
using driver::Status;
using enum driver::Status;

using driver::with_hint;

}  // namespace robcogen::command
