#include "maxima.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "backend/maxima/maxima.h"
#include "symbolic/interpret.h"

namespace robcogen::test {
namespace {

using symbolic::Arrays;
using symbolic::Program;

// Maxima prints 16 digits, and computes with exact fractions where the interpreter rounds; forward dynamics, which
// inverts inertias, shows the largest difference. Relative to the largest element of a result.
constexpr double kRounding = 1e-12;
constexpr std::uint64_t kSeed = 11;

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

// `if__inverse_dynamics([0.1, 0.2], [0.3, 0.4])`
std::string call(const std::string& name, const Program& program, const Arrays<double>& inputs) {
  std::vector<std::string> arguments;
  for (const symbolic::InputArray& array : program.inputs) {
    std::vector<std::string> elements;
    if (const auto given = inputs.find(array.name); given != inputs.end())
      for (const double value : given->second) elements.push_back(print_double(value));
    arguments.push_back(fmt::format("[{}]", fmt::join(elements, ", ")));
  }
  return fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

const char* const kShow = R"(
plain(x) := if matrixp(x) then flatten(args(x)) else if listp(x) then flatten(map(plain, x)) else x$
show(name, x) := (print("=", name), for e in plain(x) do print("=", string(float(e))), print("= end"))$
)";

// Describes how the output of `show` for one call differs from the expected values; empty if they agree.
std::string compare(const std::vector<std::string>& printed, const std::vector<double>& expected) {
  if (printed.size() != expected.size())
    return fmt::format("{} elements instead of {}", printed.size(), expected.size());
  double largest = 0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < printed.size(); ++i) {
    double value = 0;
    const char* const end = printed[i].data() + printed[i].size();
    const auto [stop, fault] = std::from_chars(printed[i].data(), end, value);
    if (fault != std::errc() || stop != end) return "no number: " + printed[i];
    if (!(std::abs(value - expected[i]) <= kRounding * largest))
      return fmt::format("element {} is {} instead of {:.17g}", i, printed[i], expected[i]);
  }
  return "";
}

}  // namespace

void WithMaxima::SetUp() {
  if (!std::string(MAXIMA).empty()) return;
  const std::string message = "Maxima is missing; Debian's package is maxima";
  if (REQUIRE_ORACLES) FAIL() << message;
  GTEST_SKIP() << message;
}

std::vector<std::string> run_maxima(const std::vector<OutputFile>& files) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / fmt::format("robcogen-maxima-{}", ::getpid());
  std::string error, loads;
  if (!write_files_if_changed(folder, files, error)) throw std::runtime_error(error);
  for (const OutputFile& file : files) loads += fmt::format("load(\"{}\")$ ", file.path.string());
  // Maxima reads no user settings and gets no answer to a question.
  const std::string command = fmt::format(
      "cd '{}' && '{}' --very-quiet --userdir=. --batch-string='{}print(\"= all is loaded\")$' > printed 2>&1 "
      "< /dev/null",
      folder.string(), MAXIMA, loads);
  const int status = std::system(command.c_str());
  const std::string printed = read_text(folder / "printed");
  fs::remove_all(folder);
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < printed.size()) {
    const std::size_t end = std::min(printed.find('\n', begin), printed.size());
    if (printed.compare(begin, 2, "= ") == 0)
      lines.push_back(printed.substr(begin + 2, printed.find_last_not_of(' ', end - 1) - begin - 1));
    begin = end + 1;
  }
  const bool complete = status == 0 && !lines.empty() && lines.back() == "all is loaded";
  EXPECT_TRUE(complete) << printed.substr(printed.size() - std::min<std::size_t>(printed.size(), 2000));
  if (complete) lines.pop_back();
  return lines;
}

OutputFile maxima_text(const backend::Library& library) {
  const std::vector<OutputFile> files = backend::maxima::print(library);
  EXPECT_EQ(files.size(), 1U);
  return files.front();
}

std::string differences(const backend::Library& library, const OutputFile& text) {
  struct Call {
    std::string name;
    std::vector<double> expected;
  };
  std::vector<Call> calls;
  std::mt19937_64 engine(kSeed);
  const int states = library.tree.dof() < 20 ? 3 : 1;  // Maxima takes seconds for each state of a humanoid
  OutputFile script = {"calls.mac", kShow};
  for (const backend::Function& f : library.functions) {
    for (int state = 0; state < states; ++state) {
      const Arrays<double> inputs = random_inputs(library, f.program, engine);
      const std::string name = text.path.stem().string() + "_" + f.kernel;
      script.text += fmt::format("show(\"{}\", {})$\n", name, call(name, f.program, inputs));
      calls.push_back({name, flattened(f.program, symbolic::interpret(f.program, inputs))});
    }
  }
  const std::vector<std::string> lines = run_maxima({text, script});
  std::string report;
  auto line = lines.begin();
  for (const Call& call : calls) {
    if (line == lines.end() || *line != call.name) return report + call.name + ": not printed\n";
    const auto end = std::find(line, lines.end(), "end");
    const std::string difference = compare({line + 1, end}, call.expected);
    if (!difference.empty()) report += call.name + ": " + difference + "\n";
    line = end == lines.end() ? end : end + 1;
  }
  return report;
}

}  // namespace robcogen::test
