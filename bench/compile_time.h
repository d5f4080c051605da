// How long the compiler takes for a robot's library.
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

// Those of a target, of the compile_commands.json that CMake writes, but for functions over many states, in folders
// `batch`, which no robot has unless it asks for them. Throws nlohmann::json::exception when the text is something
// else.
std::vector<Compilation> compilations(const std::string& json, const std::string& target);

// Seconds of processor time of all of them, one after the other, past any cache of compilers; the objects go to
// `scratch` and are removed. nullopt when there are none, or one failed.
std::optional<double> compile_time(const std::vector<Compilation>& compilations, const std::string& scratch);

}  // namespace robcogen::bench
