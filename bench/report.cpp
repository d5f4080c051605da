// Measures all robots and writes reports: tables on the console, all results as JSON, times against degrees of freedom
// as SVG.
//
//     report [--nm PROGRAM] [--compile-commands FILE] [--json FILE] [--chart FILE] [--markdown FILE] [--compiler TEXT]
//            [--flags TEXT] <benchmark program>=<static library> …
//
// Runs each benchmark program on one processor, looks up the size of the kernels in the library and, given the
// commands, compiles its sources once more to measure the time: the library of `x_bench` is the target `x`. Files are
// written only if every program succeeded. Exit status 1: one did not; 2: usage or output.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "chart.h"
#include "comparison.h"
#include "compile_time.h"
#include "machine.h"
#include "markdown.h"
#include "report_json.h"
#include "tables.h"

namespace robcogen::bench {
namespace {

constexpr int kRepetitions = 9;
constexpr double kMinTime = 0.05;  // s, of a repetition

struct Robot {
  std::string program;
  std::string library;
};

struct Arguments {
  std::string nm = "nm", compile_commands, json, chart, markdown, compiler, flags;
  std::vector<Robot> robots;
};

// Returns nullopt if they are invalid.
std::optional<Arguments> read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  const std::map<std::string, std::string*> options = {
      {"--nm", &arguments.nm},
      {"--compile-commands", &arguments.compile_commands},
      {"--json", &arguments.json},
      {"--chart", &arguments.chart},
      {"--markdown", &arguments.markdown},
      {"--compiler", &arguments.compiler},
      {"--flags", &arguments.flags}};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto option = options.find(words[i]);
    const std::size_t equals = words[i].find('=');
    if (option != options.end() && i + 1 < words.size()) {
      *option->second = words[++i];
    } else if (option == options.end() && equals != std::string::npos) {
      arguments.robots.push_back({words[i].substr(0, equals), words[i].substr(equals + 1)});
    } else {
      return std::nullopt;
    }
  }
  return arguments;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Returns nullopt, with a message on standard error, if the program or its results are invalid.
std::optional<Results> measure(const std::string& program) {
  // Results go to a file, because libraries print to standard output. With JSON also there, standard error has only
  // error messages. On one processor, benchmarks with threads are meaningless.
  const std::string file = program + ".json";
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  const std::string command = fmt::format(
      "{} --benchmark_out={} --benchmark_out_format=json --benchmark_format=json --benchmark_repetitions={}"
      " --benchmark_min_time={} --benchmark_enable_random_interleaving=true --benchmark_filter=-/threads/",
      quoted(program), quoted(file), kRepetitions, kMinTime);
  if (!output_of(command)) {
    fmt::print(stderr, "report: {} failed\n", program);
    return std::nullopt;
  }
  std::optional<Results> results;
  try {
    results = read_results(text_of(file));
  } catch (const nlohmann::json::exception& e) {
    fmt::print(stderr, "report: {} gave no results: {}\n", program, e.what());
  }
  std::filesystem::remove(file, ignored);
  return results;
}

// Adds data about the library that need no run. The table is useful even without them.
void look_at_library(const Arguments& arguments, const Robot& robot, Results& results) {
  results.bytes = kernel_sizes(output_of(quoted(arguments.nm) + " -S -C " + quoted(robot.library)).value_or(""));
  if (arguments.compile_commands.empty()) return;
  const std::string program = std::filesystem::path(robot.program).stem().string();
  const std::string target = program.substr(0, program.rfind("_bench"));
  try {
    const std::vector<Compilation> list = compilations(text_of(arguments.compile_commands), target);
    results.compile_seconds = compile_time(list, robot.program + ".o");
  } catch (const nlohmann::json::exception& e) {
    fmt::print(stderr, "report: no time of compilation: {}\n", e.what());
  }
}

bool write(const std::string& path, const std::string& text) {
  if (path.empty()) return true;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    fmt::print(stderr, "report: cannot write {}\n", path);
    return false;
  }
  fmt::print("written: {}\n", path);
  return true;
}

void print_legend(const Setup& setup) {
  fmt::print(
      "\nns: processor time of one call with sin and cos, median of {} repetitions over 1024 states in turn; given "
      "trig:\n"
      "of a call that takes them; batch: of one state in calls for many; instr: multiplications and additions, fused\n"
      "where one feeds the other; path: cycles of the longest chain; bound: the greater of path and instr / 2; "
      "cycles:\n"
      "measured, sin and cos given, and their ratio to the bound; bytes: the compiled kernel; compiled: processor "
      "time\n"
      "for all sources of the library but those of batches; x: time of the other library / time of the generated "
      "code.\n",
      setup.repetitions);
  fmt::print(
      "{}{}\n",
      setup.pinned_to ? fmt::format("On processor {} alone", *setup.pinned_to) : "On no processor in particular",
      setup.processor.empty() ? "." : fmt::format(", {}.", setup.processor));
  if (!setup.compiler.empty()) fmt::print("Compiled by {}: {}\n", setup.compiler, setup.flags);
}

int report(const Arguments& arguments) {
  const Setup setup = {arguments.compiler,     arguments.flags, processor_name(),
                       pin_to_one_processor(), kRepetitions,    kMinTime};
  std::vector<Results> all;
  fmt::print("{}", function_heading());
  for (const Robot& robot : arguments.robots) {
    std::optional<Results> results = measure(robot.program);
    if (!results) continue;
    look_at_library(arguments, robot, *results);
    fmt::print("{}", function_rows(*results));
    std::fflush(stdout);
    all.push_back(*results);
  }
  const std::string compared = comparison_table(all);
  if (!compared.empty()) fmt::print("\n{}", compared);
  print_legend(setup);
  if (all.size() < arguments.robots.size()) return 1;
  const bool written = write(arguments.json, report_json(setup, all)) &&
                       write(arguments.chart, svg(chart_panels(all))) && write(arguments.markdown, markdown(all));
  return written ? 0 : 2;
}

}  // namespace
}  // namespace robcogen::bench

int main(int argc, char** argv) {
  const auto arguments = robcogen::bench::read_arguments({argv + 1, argv + argc});
  if (!arguments) {
    std::fprintf(
        stderr,
        "usage: %s [--nm PROGRAM] [--compile-commands FILE] [--json FILE] [--chart FILE] [--markdown FILE]\n"
        "       [--compiler TEXT] [--flags TEXT] <benchmark program>=<static library> ...\n",
        argv[0]);
    return 2;
  }
  return robcogen::bench::report(*arguments);
}
