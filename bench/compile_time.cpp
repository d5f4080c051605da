#include "compile_time.h"

#include <sys/resource.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "machine.h"

namespace robcogen::bench {

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// Processor time (s) of all child processes that have ended.
double time_of_children() {
  rusage usage = {};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

std::vector<Compilation> compilations(const std::string& json, const std::string& target) {
  std::vector<Compilation> found;
  const std::string folder = "CMakeFiles/" + target + ".dir/";
  for (const nlohmann::json& entry : nlohmann::json::parse(json)) {
    const std::string command = entry.at("command").get<std::string>();
    // CMake writes: compiler, flags, `-o` object `-c` source.
    const std::size_t begin = command.find(" -o "), end = command.find(" -c ", begin);
    if (begin == std::string::npos || end == std::string::npos) continue;
    const std::string object = command.substr(begin + 4, end - begin - 4);
    const bool is_of_target = object.rfind(folder, 0) == 0 || object.find("/" + folder) != std::string::npos;
    if (is_of_target && object.find("/batch/") == std::string::npos)
      found.push_back({entry.at("directory").get<std::string>(), command, object});
  }
  return found;
}

std::optional<double> compile_time(const std::vector<Compilation>& compilations, const std::string& scratch) {
  if (compilations.empty()) return std::nullopt;
  const double before = time_of_children();
  bool ok = true;
  for (const Compilation& c : compilations) {
    const std::string command = replaced(c.command, c.object, quoted(scratch));
    ok = ok && output_of("cd " + quoted(c.directory) + " && CCACHE_DISABLE=1 " + command).has_value();
  }
  const double after = time_of_children();
  std::error_code ignored;
  std::filesystem::remove(scratch, ignored);
  std::filesystem::remove(std::filesystem::path(scratch).replace_extension("su"), ignored);  // of -fstack-usage
  return ok ? std::optional(after - before) : std::nullopt;
}

}  // namespace robcogen::bench
