#include "command/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#ifdef _WIN32
#include <io.h>
#endif

namespace robcogen::command {
namespace {

bool output_is_lost = false;
bool message_is_lost = false;

bool write_all(std::string_view text, std::FILE* stream) {
  return text.empty() || std::fwrite(text.data(), 1, text.size(), stream) == text.size();
}

std::string loss_of_output(int number) {
  return fmt::format(
      "robcogen: error: cannot write standard output: {} [output-lost]", std::generic_category().message(number));
}

[[noreturn]] void lose_output(int number) {
  output_is_lost = true;
  throw Failure{wrong_usage, loss_of_output(number)};
}

// Whether standard output is open but not writable. Flushing reports such a stream even if nothing was written.
bool takes_nothing() {
  return ::write(STDOUT_FILENO, "", 0) < 0;
}

}  // namespace

#ifdef _WIN32
void prepare_streams() {
  // Generated text has the same bytes everywhere: a line does not end with a carriage return.
  for (std::FILE* stream : {stdin, stdout, stderr}) static_cast<void>(::_setmode(::_fileno(stream), _O_BINARY));
}
#else
void prepare_streams() {
  // A closed stream is opened in the wrong direction, so that using it remains an error.
  for (const auto& [stream, direction] :
       {std::pair(STDIN_FILENO, O_WRONLY), std::pair(STDOUT_FILENO, O_RDONLY), std::pair(STDERR_FILENO, O_RDONLY)})
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF) static_cast<void>(::open("/dev/null", direction));
  std::signal(SIGPIPE, SIG_IGN);
}
#endif

void write_output(std::string_view text) {
  errno = 0;
  if (!write_all(text, stdout)) lose_output(errno);
}

void flush_output() {
  errno = 0;
  if (std::fflush(stdout) != 0) lose_output(errno);
}

void report(std::string_view text) {
  if (!write_all(text, stderr)) message_is_lost = true;
}

Status close_streams(Status status) {
  if (!output_is_lost && (std::fflush(stdout) != 0 || takes_nothing())) {
    output_is_lost = true;
    report(loss_of_output(errno) + "\n");
  }
  return output_is_lost || message_is_lost ? wrong_usage : status;
}

}  // namespace robcogen::command
