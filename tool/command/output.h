// Standard output and standard error. Every subcommand writes through these functions, so that a full disk, a closed
// stream or a reader that has exited leads to exit status 2 and a single message.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "command/status.h"

namespace robcogen::command {

// Must be called before any file is opened: a file must not take the place of a closed standard stream, and a pipe
// without a reader must cause a write error, not a signal.
void prepare_streams();

// Writes to standard output. Throws a Failure if writing fails.
void write_output(std::string_view text);
void flush_output();

template <class... Arguments>
void print_output(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  write_output(fmt::format(format, std::forward<Arguments>(arguments)...));
}

// Writes to standard error; never throws.
void report(std::string_view text);

// The last step of main. Returns `status`, or wrong_usage if standard output or a message was lost. Reports the loss,
// unless main has reported a Failure about it.
Status close_streams(Status status);

}  // namespace robcogen::command
