// One table of all robots and functions: time, operation counts and code size.
//
//     report [--nm PROGRAM] <benchmark program>=<static library> …
//
// Runs each benchmark program, reads its results as JSON, and looks up the size of the kernels in the library.
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

// Quoted for the shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

// Standard output of a command; nullopt when it could not run or failed.
std::optional<std::string> output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string text;
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  const int status = pclose(pipe);
  if (status == -1 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return text;
}

// Bytes of each kernel compiled for double, by its name. `listing` is the output of `nm -S -C`: address, size, type and
// demangled name, such as `void hyl::kernel::inverse_dynamics<double>(double const*, …)`.
std::map<std::string, long> kernel_sizes(const std::string& listing) {
  std::map<std::string, long> sizes;
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    const std::string scope = "kernel::";
    const std::size_t scope_at = line.find(scope);
    const std::size_t end = line.find("<double>(");
    if (scope_at == std::string::npos || end == std::string::npos || end < scope_at) continue;
    const std::size_t begin = scope_at + scope.size();
    std::istringstream fields(line);
    std::string address, size;
    if (!(fields >> address >> size)) continue;
    // Each object file that uses a kernel may hold a copy; the linker keeps one.
    sizes[line.substr(begin, end - begin)] = std::strtol(size.c_str(), nullptr, 16);
  }
  return sizes;
}

struct Row {
  std::string function;
  std::string kernel;
  double nanoseconds = 0;
  std::map<std::string, long> counts;
};

struct Results {
  std::string robot;
  std::vector<Row> rows;
};

const std::vector<std::string> kCounts = {"mul", "add", "div", "sincos", "instructions", "critical_path"};

// The medians of a run with repetitions.
Results read_results(const std::string& json) {
  const nlohmann::json document = nlohmann::json::parse(json);
  Results results;
  results.robot = document.at("context").value("robot", "");
  for (const nlohmann::json& entry : document.at("benchmarks")) {
    if (entry.value("aggregate_name", "") != "median") continue;
    Row row;
    row.function = entry.at("run_name").get<std::string>();
    row.kernel = entry.value("label", "");
    row.nanoseconds = entry.at("cpu_time").get<double>();
    for (const std::string& name : kCounts) {
      if (entry.contains(name)) row.counts[name] = static_cast<long>(entry.at(name).get<double>());
    }
    results.rows.push_back(row);
  }
  return results;
}

void print_heading() {
  std::printf(
      "%-16s %-44s %9s %6s %6s %4s %6s %6s %6s %9s\n", "robot", "function", "ns", "mul", "add", "div", "sincos",
      "instr", "path", "bytes");
}

void print_row(const std::string& robot, const Row& row, const std::map<std::string, long>& sizes) {
  const auto size = sizes.find(row.kernel);
  const std::string bytes = size == sizes.end() ? "-" : std::to_string(size->second);
  std::printf("%-16s %-44s %9.1f", robot.c_str(), row.function.c_str(), row.nanoseconds);
  const std::array<int, 6> widths = {6, 6, 4, 6, 6, 6};
  for (std::size_t i = 0; i < kCounts.size(); ++i) {
    // A benchmark leaves zeros out; one of a kernel without counts has none at all.
    const auto count = row.counts.find(kCounts[i]);
    const std::string text = row.counts.empty() ? "-" : std::to_string(count == row.counts.end() ? 0 : count->second);
    std::printf(" %*s", widths[i], text.c_str());
  }
  std::printf(" %9s\n", bytes.c_str());
}

// False when the program or its results are no good.
bool report_robot(const std::string& program, const std::string& library, const std::string& nm) {
  const std::string options =
      " --benchmark_format=json --benchmark_repetitions=5 --benchmark_report_aggregates_only=true"
      " --benchmark_min_time=0.05";
  const std::optional<std::string> json = output_of(quoted(program) + options);
  if (!json) {
    std::fprintf(stderr, "report: %s failed\n", program.c_str());
    return false;
  }
  Results results;
  try {
    results = read_results(*json);
  } catch (const nlohmann::json::exception& e) {
    std::fprintf(stderr, "report: %s printed no results: %s\n", program.c_str(), e.what());
    return false;
  }
  // Without sizes the table is still worth printing.
  const std::map<std::string, long> sizes =
      kernel_sizes(output_of(quoted(nm) + " -S -C " + quoted(library)).value_or(""));
  for (const Row& row : results.rows) print_row(results.robot, row, sizes);
  std::fflush(stdout);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::string nm = "nm";
  std::vector<std::string> robots;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--nm") == 0 && i + 1 < argc) {
      nm = argv[++i];
    } else {
      robots.push_back(argv[i]);
    }
  }
  print_heading();
  bool good = true;
  for (const std::string& pair : robots) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string::npos) {
      std::fprintf(stderr, "usage: %s [--nm PROGRAM] <benchmark program>=<static library> ...\n", argv[0]);
      return 2;
    }
    good = report_robot(pair.substr(0, equals), pair.substr(equals + 1), nm) && good;
  }
  std::printf(
      "\nns: median of 5 repetitions, one call with sin and cos, 1024 states in turn; instr: multiplications and\n"
      "additions, fused where one feeds the other; path: cycles of the longest chain; bytes: the compiled kernel.\n");
  return good ? 0 : 1;
}
