#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "command/output.h"
#include "command/subcommands.h"
#include "server/serve.h"

namespace robcogen::command {
namespace {

// Returns as soon as there is any input, because an editor waits for the answer before it goes on.
std::size_t read_input(char* bytes, std::size_t size) {
  constexpr std::size_t kMost = 1 << 16;  // Windows takes fewer bytes at a time than std::size_t can count
  while (true) {
    const ssize_t count = ::read(STDIN_FILENO, bytes, static_cast<unsigned>(std::min(size, kMost)));
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) return 0;
  }
}

}  // namespace

Status language_server(const std::vector<std::filesystem::path>& import_folders) {
  const auto write = [](std::string_view bytes) {
    write_output(bytes);
    flush_output();
  };
  return server::serve(&read_input, write, import_folders) ? ok : wrong_input;
}

}  // namespace robcogen::command
