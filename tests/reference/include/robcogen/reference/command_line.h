// The command line of self-checks.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace robcogen::reference {

struct CommandLine {
  std::uint64_t seed = 1;
  int samples = 20;
};

// `[--seed N] [--samples N]`; nullopt, with the usage on standard error, for anything else.
inline std::optional<CommandLine> command_line(int argc, char** argv) {
  CommandLine result;
  for (int i = 1; i < argc; i += 2) {
    char* end = nullptr;
    const bool has_value = i + 1 < argc;
    if (has_value && std::strcmp(argv[i], "--seed") == 0) result.seed = std::strtoull(argv[i + 1], &end, 10);
    if (has_value && std::strcmp(argv[i], "--samples") == 0)
      result.samples = static_cast<int>(std::strtol(argv[i + 1], &end, 10));
    if (end == nullptr || end == argv[i + 1] || *end != '\0' || result.samples < 1) {
      std::fprintf(stderr, "usage: %s [--seed N] [--samples N]\n", argv[0]);
      return std::nullopt;
    }
  }
  return result;
}

}  // namespace robcogen::reference
