#include "node.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "backend/common/overloads.h"
#include "backend/javascript/javascript.h"

namespace robcogen::test {
namespace {

using symbolic::Arrays;
using symbolic::Program;
using symbolic::Role;

// Both sides do the same operations in the same order. Sines and cosines differ by a unit in the last place, which
// solving for accelerations amplifies. Relative to the largest element of a result.
constexpr double kRounding = 1e-12;
constexpr std::uint64_t kSeed = 23;
constexpr int kStates = 3;

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::string array(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::vector<std::string> texts(const std::vector<double>& values) {
  std::vector<std::string> result;
  for (const double value : values) result.push_back(print_double(value));
  return result;
}

// The `count` rows of a matrix whose rows are `row` elements apart and whose columns are `column` elements apart.
std::string rows(const std::vector<std::string>& elements, std::size_t count, std::size_t row, std::size_t column) {
  std::vector<std::string> result;
  for (std::size_t r = 0; r < count; ++r) {
    std::vector<std::string> items;
    for (std::size_t c = 0; c < elements.size() / count; ++c) items.push_back(elements[r * row + c * column]);
    result.push_back(array(items));
  }
  return array(result);
}

// Spells an argument as the module expects it.
std::string argument(const symbolic::InputArray& input, const std::vector<double>& values) {
  const std::vector<std::string> elements = texts(values);
  if (input.role == Role::link_wrenches) return rows(elements, elements.size() / 6, 6, 1);
  if (input.role == Role::inertia_factor) {
    const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(elements.size()))));
    return rows(elements, n, 1, n);
  }
  if (input.role == Role::variables) return fmt::format("{}", fmt::join(elements, ", "));
  if (input.role != Role::parameters) return array(elements);
  std::vector<std::string> members;
  for (std::size_t k = 0; k < elements.size(); ++k) members.push_back(input.elements[k] + ": " + elements[k]);
  return fmt::format("{{ {} }}", fmt::join(members, ", "));
}

// `transforms.homogeneous.fr_base_X_fr_foot([0.1, 0.2])`
std::string call(const backend::OverloadedFunction& callable, const Program& program, const Arrays<double>& inputs) {
  std::string name = "robot." + callable.scope + (callable.scope.empty() ? "" : "::") + callable.name;
  for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::")) name.replace(at, 2, ".");
  std::vector<std::string> arguments;
  for (const symbolic::InputArray& input : program.inputs) {
    const auto given = inputs.find(input.name);
    arguments.push_back(argument(input, given == inputs.end() ? std::vector<double>() : given->second));
  }
  return fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

// Prints each result as a flat list of numbers, whether it is one array or an object of several; matrices row by row.
const char* const kShow = R"(
const flat = (x) => (typeof x === "number" ? [x] : (Array.isArray(x) ? x : Object.values(x)).flatMap(flat));
const show = (x) => console.log(flat(x).join(" "));
)";

// Describes how a printed line differs from the expected values; empty if they agree.
std::string compare(const std::string& line, const std::vector<double>& expected) {
  double largest = 0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  const char* at = line.data();
  const char* const end = line.data() + line.size();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    double value = 0;
    const auto [stop, fault] = std::from_chars(at, end, value);
    if (fault != std::errc() || (stop != end && *stop != ' ')) return fmt::format("element {} is not a number", i);
    at = stop == end ? end : stop + 1;
    if (!(std::abs(value - expected[i]) <= kRounding * largest))
      return fmt::format("element {} is {} instead of {:.17g}", i, value, expected[i]);
  }
  return at == end ? "" : "too many elements";
}

}  // namespace

void WithNode::SetUp() {
  if (!std::string(NODE).empty()) return;
  const std::string message = "Node is missing; Debian's package is nodejs";
  if (REQUIRE_ORACLES) FAIL() << message;
  GTEST_SKIP() << message;
}

std::vector<std::string> run_node(const std::vector<OutputFile>& files) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / fmt::format("robcogen-node-{}", ::getpid());
  std::string error;
  if (!write_files_if_changed(folder, files, error)) throw std::runtime_error(error);
  const std::string command = fmt::format(
      "cd '{}' && '{}' '{}' > printed 2> said < /dev/null", folder.string(), NODE, files.back().path.string());
  const int status = std::system(command.c_str());
  const std::string printed = read_text(folder / "printed"), said = read_text(folder / "said");
  fs::remove_all(folder);
  EXPECT_EQ(status, 0) << said.substr(0, 2000);
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < printed.size();) {
    const std::size_t end = std::min(printed.find('\n', begin), printed.size());
    lines.push_back(printed.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

OutputFile module_of(const backend::Library& library) {
  const std::vector<OutputFile> files = backend::javascript::print(library);
  EXPECT_EQ(files.size(), 1U);
  return files.front();
}

std::string differences(const backend::Library& library, const OutputFile& module, int* calls) {
  struct Call {
    std::string text;
    std::vector<double> expected;
  };
  std::vector<Call> all;
  std::mt19937_64 engine(kSeed);
  OutputFile script = {"calls.mjs", "import * as robot from \"./" + module.path.string() + "\";\n" + kShow};
  for (const backend::OverloadedFunction& callable : backend::overloaded_functions(library)) {
    // Each overload is called with its own arguments; the module's function supplies defaults for the ones that it
    // leaves out.
    for (const backend::Function* overload : callable.overloads) {
      for (int state = 0; state < kStates; ++state) {
        const Arrays<double> inputs = random_inputs(library, overload->program, engine);
        const bool leads = std::equal(
            overload->program.inputs.begin(), overload->program.inputs.end(), callable.longest().program.inputs.begin(),
            [](const auto& a, const auto& b) { return a.name == b.name; });
        EXPECT_TRUE(leads) << overload->kernel << " takes other arguments first";
        all.push_back(
            {call(callable, overload->program, inputs),
             flattened(overload->program, symbolic::interpret(overload->program, inputs))});
        script.text += "show(" + all.back().text + ");\n";
      }
    }
  }
  const std::vector<std::string> lines = run_node({module, script});
  if (calls != nullptr) *calls = static_cast<int>(all.size());
  if (lines.size() != all.size()) return fmt::format("{} lines for {} calls\n", lines.size(), all.size());
  std::string report;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string difference = compare(lines[i], all[i].expected);
    if (!difference.empty()) report += all[i].text.substr(0, all[i].text.find('(')) + ": " + difference + "\n";
  }
  return report;
}

}  // namespace robcogen::test
