// Runs the generator as a program.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace robcogen::test {

struct Outcome {
  int status = -1;
  std::string output;  // standard output
  std::string errors;  // standard error
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

// A new folder for a test, empty at first.
class Scratch {
 public:
  explicit Scratch(const std::string& name)
      : path(std::filesystem::temp_directory_path() / ("robcogen-" + name + "-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path path;
};

// `arguments` are in shell syntax; `prefix` may set environment variables.
inline Outcome run_tool(const std::string& arguments, const std::string& input = "", const std::string& prefix = "") {
  const Scratch scratch("run");
  write_text(scratch.path / "input", input);
  const std::string command = prefix + " '" ROBCOGEN_TOOL "' " + arguments + " < '" +
                              (scratch.path / "input").string() + "' > '" + (scratch.path / "output").string() +
                              "' 2> '" + (scratch.path / "errors").string() + "'";
  const int status = std::system(command.c_str());
  return {
      WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(scratch.path / "output"),
      read_text(scratch.path / "errors")};
}

inline std::string quoted(const std::filesystem::path& path) {
  return "'" + path.string() + "'";
}

inline std::filesystem::path robot(const std::string& name) {
  return std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / name / (name + ".kindsl");
}

}  // namespace robcogen::test
