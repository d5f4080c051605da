// The time that the compiler takes for a robot's library.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robcogen::bench {

// The compilation of one source.
struct Compilation {
  std::string directory;
  std::string command;
  std::string object;  // as the command names it
};

// The compilations of a target in the compile_commands.json that CMake writes, without functions over many states,
// which are in folders `batch` and which a robot has only on request. Throws nlohmann::json::exception if the text is
// something else.
std::vector<Compilation> compilations(const std::string& json, const std::string& target);

// Processor time (s) of all of them, one after the other, without compiler caches; the objects go to `scratch` and are
// removed. nullopt if there are none, or one failed.
std::optional<double> compile_time(const std::vector<Compilation>& compilations, const std::string& scratch);

}  // namespace robcogen::bench
