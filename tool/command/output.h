// Standard output and standard error. Every subcommand writes through these functions, so that a full disk, a closed
// stream or a reader that has exited leads to exit status 2 and one message.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "command/status.h"

namespace robcogen::command {

// Call it before any file is opened: a file must not take the place of a standard stream that is closed, and a pipe
// without a reader must be an error of writing, not a signal.
void prepare_streams();

// To standard output. A Failure when writing fails.
void write_output(std::string_view text);
void flush_output();

template <class... Arguments>
void print_output(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  write_output(fmt::format(format, std::forward<Arguments>(arguments)...));
}

// To standard error; never throws.
void report(std::string_view text);

// The last step of main: `status`, or wrong_usage when standard output or a message was lost. Reports it, unless
// main has reported a Failure about it.
Status close_streams(Status status);

}  // namespace robcogen::command
