// The operation counts in the banners of kernels are those of the text beneath them.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "patterns.h"

namespace robcogen::test {
namespace {

namespace fs = std::filesystem;

// mul, add, div, sqrt, sincos
using Counts = std::array<int, 5>;

int occurrences(const std::string& line, const std::string& what) {
  int count = 0;
  for (std::size_t at = line.find(what); at != std::string::npos; at = line.find(what, at + what.size())) ++count;
  return count;
}

// Binary operators are surrounded by blanks; a unary minus is not, and does not count as an operation.
void add_operators(const std::string& line, Counts& counts) {
  counts[0] += occurrences(line, " * ");
  counts[1] += occurrences(line, " + ") + occurrences(line, " - ");
  counts[2] += occurrences(line, " / ");
  counts[3] += occurrences(line, "sqrt(");
  // `const auto [s_q, c_q] = trig_2[1];`: one of those that are computed together.
  for (const char* call : {"sincos(", "sincos_of_small(", " = sin(", " = cos("}) counts[4] += occurrences(line, call);
  if (line.find("] = trig") != std::string::npos)
    counts[4] += whole_match(line, R"(.*\] = trig(_\d+)?\[.*)").has_value();
}

// `// 26 mul, 19 add, 1 div, 2 sincos: …`
bool read_banner(const std::string& line, Counts& counts) {
  const std::string pattern =
      R"(// (\d+) mul, (\d+) add(?:, (\d+) div)?(?:, (\d+) sqrt)?(?:, (\d+) sincos)?(?:, \d+ lane moves)?[:.].*)";
  const auto match = line.starts_with("// ") ? whole_match(line, pattern) : std::nullopt;
  if (!match) return false;
  for (std::size_t k = 0; k < counts.size(); ++k) counts[k] = (*match)[k + 1].empty() ? 0 : std::stoi((*match)[k + 1]);
  return true;
}

// The angle whose sine or cosine a line names: `const Scalar& s_HFE = sin_q[1];`
void add_angle(const std::string& line, std::set<int>& angles) {
  if (line.find("_q[") == std::string::npos) return;
  if (const auto match = whole_match(line, R"(.* = (?:sin|cos)_q\[(\d+)\];)")) angles.insert(std::stoi((*match)[1]));
}

// The text after `word` up to the parenthesis; empty when the line does not have the word.
std::string name_behind(const std::string& word, const std::string& line) {
  const std::size_t at = line.find(word);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + word.size();
  return line.substr(begin, line.find('(', begin) - begin);
}

// Returns the number of kernels in the file. A kernel that calls its core has the operations of the core, plus a sine
// and cosine for each angle that the core reads. A kernel in parts has the operations of its parts, which precede it.
int check_file(const fs::path& path) {
  std::ifstream file(path);
  int kernels = 0;
  bool inside = false, in_cores = false, in_parts = false;
  Counts expected{}, found{};
  std::set<int> angles;
  std::string name;
  std::map<std::string, Counts> cores;  // including the sines and cosines that they are given
  for (std::string line; std::getline(file, line);) {
    if (line == "namespace core {") in_cores = true;
    if (line == "}  // namespace core") in_cores = false;
    if (line == "namespace parts {") in_parts = true;
    if (line == "}  // namespace parts") in_parts = false;
    if (read_banner(line, expected)) {
      ++kernels;
      inside = true;
    } else if (inside && !name_behind("void ", line).empty()) {
      name = name_behind("void ", line);
    } else if (inside && !name_behind("  core::", line).empty()) {
      const Counts core = cores.at(name_behind("  core::", line));
      for (std::size_t k = 0; k < found.size(); ++k) found[k] += core[k];
    } else if (
        (inside || in_parts) && line.starts_with("  ") && !line.starts_with("  //") &&
        !line.starts_with("  robcogen::sincos_") && !line.starts_with("  robcogen::called::sincos_")) {
      add_operators(line, found);
      if (in_cores) add_angle(line, angles);
    } else if (inside && line.starts_with("}")) {
      EXPECT_EQ(found, expected) << path << ", kernel " << kernels;
      inside = false;
      if (in_cores) {
        cores[name] = found;
        cores[name][4] += static_cast<int>(angles.size());
      }
      found = {};
      angles.clear();
    }
  }
  return kernels;
}

int check_folder(const fs::path& folder) {
  int kernels = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().parent_path().filename() == "kernel") kernels += check_file(entry.path());
  return kernels;
}

#ifdef SAMPLES_DIR
TEST(OperationCount, OfSamplesIsThatOfTheText) {
  EXPECT_GE(check_folder(SAMPLES_DIR), 30);
}
#endif

#ifdef ROBOTS_DIR
TEST(OperationCount, OfRobotsIsThatOfTheText) {
  EXPECT_GE(check_folder(ROBOTS_DIR), 100);
}
#endif

}  // namespace
}  // namespace robcogen::test
