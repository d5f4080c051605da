#include "results.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

namespace robcogen::bench {

const std::vector<std::string> kCounts = {"mul", "add", "div", "sqrt", "sincos", "instructions", "critical_path"};
const std::vector<std::string> kQuantities = {
    "inverse_dynamics", "forward_dynamics", "inertia_matrix", "jacobian", "transform"};

namespace {

// The statistics of at least one value.
Time time_of(std::vector<double> nanoseconds) {
  std::sort(nanoseconds.begin(), nanoseconds.end());
  const std::size_t n = nanoseconds.size();
  const double median = n % 2 == 1 ? nanoseconds[n / 2] : (nanoseconds[n / 2 - 1] + nanoseconds[n / 2]) / 2;
  return {median, nanoseconds.front(), nanoseconds.back()};
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

// A line of the context entry `absent`: "library: reason".
Absence absence(const std::string& line) {
  const std::size_t colon = line.find(": ");
  return colon == std::string::npos ? Absence{line, ""} : Absence{line.substr(0, colon), line.substr(colon + 2)};
}

void read_context(const nlohmann::json& context, Results& results) {
  results.robot = context.value("robot", "");
  results.joints = std::atoi(context.value("joints", "0").c_str());
  results.states = std::atoi(context.value("states", "0").c_str());
  results.floating_base = context.value("floating_base", "no") == "yes";
  results.peers = lines(context.value("peers", ""));
  for (const std::string& line : lines(context.value("absent", ""))) results.absent.push_back(absence(line));
  for (const std::string& quantity : kQuantities) {
    const std::string key = "compared/" + quantity;
    if (context.contains(key)) results.compared[quantity] = context.at(key).get<std::string>();
  }
  results.processors = context.value("num_cpus", 0);
  results.megahertz = context.value("mhz_per_cpu", 0);
  results.frequency_scaling = context.value("cpu_scaling_enabled", false);
}

// The time of one call; if a call computes several states (items), the time per state.
double nanoseconds_of(const nlohmann::json& entry) {
  const double states_per_second = entry.value("items_per_second", 0.0);
  return states_per_second > 0 ? 1e9 / states_per_second : entry.at("cpu_time").get<double>();
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Adds the measurement of a variant, `<function>/given_trig` or `<function>/batch`, with or without the robot's name in
// front, to its function. Returns whether it was one.
bool is_variant(const std::string& name, const Time& time, Results& results) {
  for (const auto& [end, member] :
       {std::pair("/given_trig", &Function::given_trig), std::pair("/batch", &Function::batch)}) {
    if (!ends_with(name, end)) continue;
    for (Function& f : results.functions) {
      if (name != f.name + end && !ends_with(name, "/" + f.name + end)) continue;
      f.*member = time;
      return true;
    }
  }
  return false;
}

constexpr const char* kClock = "clock/";  // and the number of cycles

// Reads one benchmark from all its repetitions.
void read_benchmark(const std::vector<nlohmann::json>& repetitions, Results& results) {
  const nlohmann::json& first = repetitions.front();
  std::vector<double> nanoseconds;
  for (const nlohmann::json& entry : repetitions) nanoseconds.push_back(nanoseconds_of(entry));
  const Time time = time_of(nanoseconds);
  const std::string name = first.at("run_name").get<std::string>();
  if (name.rfind(kClock, 0) == 0) {
    results.gigahertz = std::strtod(name.c_str() + std::strlen(kClock), nullptr) / time.median;
    return;
  }
  if (is_variant(name, time, results)) return;
  const std::size_t slash = name.find('/');
  const std::string library = name.substr(0, slash);
  if (std::find(results.peers.begin(), results.peers.end(), library) != results.peers.end()) {
    results.peer_times.push_back({library, slash == std::string::npos ? "" : name.substr(slash + 1), time});
    return;
  }
  Function function{name, first.value("label", ""), time, {}};
  for (const std::string& count : kCounts) {
    if (first.contains(count)) function.counts[count] = static_cast<long>(first.at(count).get<double>());
  }
  results.functions.push_back(function);
}

}  // namespace

Results read_results(const std::string& json) {
  const nlohmann::json document = nlohmann::json::parse(json);
  Results results;
  read_context(document.at("context"), results);
  // Repetitions come in the order in which they were run; a family is one call that added a benchmark.
  std::map<int, std::vector<nlohmann::json>> repetitions;
  for (const nlohmann::json& entry : document.at("benchmarks")) {
    if (entry.value("run_type", "") != "iteration") continue;  // means and other statistics
    repetitions[entry.at("family_index").get<int>()].push_back(entry);
  }
  // Variants are read after their functions.
  const auto is_variant_name = [](const std::vector<nlohmann::json>& entries) {
    const std::string name = entries.front().at("run_name").get<std::string>();
    return ends_with(name, "/given_trig") || ends_with(name, "/batch");
  };
  for (const bool variants : {false, true}) {
    for (const auto& [family, entries] : repetitions) {
      if (is_variant_name(entries) == variants) read_benchmark(entries, results);
    }
  }
  return results;
}

std::optional<double> least_cycles(const Function& function) {
  if (function.counts.empty()) return std::nullopt;
  const auto count = [&](const char* what) {
    const auto found = function.counts.find(what);
    return found == function.counts.end() ? 0.0 : static_cast<double>(found->second);
  };
  return std::max(count("critical_path"), count("instructions") / 2);
}

std::optional<double> cycles(const Results& results, const Function& function) {
  if (!function.given_trig || results.gigahertz == 0) return std::nullopt;
  return function.given_trig->median * results.gigahertz;
}

namespace {

// Sizes of kernels by the text after `kernel::`, such as `core::in_lanes::forward_dynamics`.
std::map<std::string, long> kernel_symbols(const std::string& listing) {
  std::map<std::string, long> sizes;
  std::istringstream stream(listing);
  for (std::string line; std::getline(stream, line);) {
    const std::string scope = "kernel::";
    const std::size_t scope_at = line.find(scope);
    const std::size_t end = line.find("<double>(");
    if (scope_at == std::string::npos || end == std::string::npos || end < scope_at) continue;
    // Functions over many states call the kernels, and are not kernels themselves.
    const std::string outer = "::batch::";
    if (scope_at >= outer.size() && line.compare(scope_at - outer.size(), outer.size(), outer) == 0) continue;
    const std::size_t begin = scope_at + scope.size();
    std::istringstream fields(line);
    std::string address, size;
    if (!(fields >> address >> size)) continue;
    // Each object file that uses a kernel may hold a copy; the linker keeps one. If a program chooses the kernel for a
    // processor, the function of this name only calls it: the largest is that for the baseline.
    long& largest = sizes[line.substr(begin, end - begin)];
    largest = std::max(largest, std::strtol(size.c_str(), nullptr, 16));
  }
  return sizes;
}

// Size of the function with those that it chooses from or consists of: `in_lanes::`, `one_by_one::`, and their
// `parts::`.
long whole_size(const std::map<std::string, long>& symbols, const std::string& scope, const std::string& name) {
  long size = 0;
  for (const std::string way : {"", "in_lanes::", "one_by_one::"}) {
    const auto whole = symbols.find(scope + way + name);
    if (whole != symbols.end()) size += whole->second;
    const std::string part = scope + way + "parts::" + name + "_";
    for (auto it = symbols.lower_bound(part); it != symbols.end() && it->first.compare(0, part.size(), part) == 0; ++it)
      if (it->first.find_first_not_of("0123456789", part.size()) == std::string::npos) size += it->second;
  }
  return size;
}

}  // namespace

std::map<std::string, long> kernel_sizes(const std::string& listing) {
  const std::map<std::string, long> symbols = kernel_symbols(listing);
  std::map<std::string, long> sizes;
  for (const auto& [name, size] : symbols) {
    if (name.find(':') != std::string::npos) continue;
    sizes[name] = whole_size(symbols, "", name);
    // The part of a kernel after sines and cosines, its core, is a separate function. A kernel that is smaller than its
    // core calls it; one that is larger, or computes its limbs in lanes itself, contains a copy.
    const long core = whole_size(symbols, "core::", name);
    if (sizes[name] < core) sizes[name] += core;
  }
  return sizes;
}

}  // namespace robcogen::bench
