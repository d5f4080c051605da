// The operation counts in the banners of kernels are those of the text beneath them.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

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

// Binary operators stand between blanks; a unary minus does not, and is no operation.
void add_operators(const std::string& line, Counts& counts) {
  counts[0] += occurrences(line, " * ");
  counts[1] += occurrences(line, " + ") + occurrences(line, " - ");
  counts[2] += occurrences(line, " / ");
  counts[3] += occurrences(line, "sqrt(");
  counts[4] += occurrences(line, "sincos(") + occurrences(line, "] = trig[") + occurrences(line, " = sin(") +
               occurrences(line, " = cos(");
}

// `// 26 mul, 19 add, 1 div, 2 sincos: …`
bool read_banner(const std::string& line, Counts& counts) {
  static const std::regex pattern(
      R"(// (\d+) mul, (\d+) add(?:, (\d+) div)?(?:, (\d+) sqrt)?(?:, (\d+) sincos)?[:.].*)");
  std::smatch match;
  if (!std::regex_match(line, match, pattern)) return false;
  for (std::size_t k = 0; k < counts.size(); ++k) counts[k] = match[k + 1].matched ? std::stoi(match[k + 1]) : 0;
  return true;
}

// Returns the number of kernels in the file.
int check_file(const fs::path& path) {
  std::ifstream file(path);
  int kernels = 0;
  bool inside = false;
  Counts expected{}, found{};
  for (std::string line; std::getline(file, line);) {
    if (read_banner(line, expected)) {
      ++kernels;
      inside = true;
      found = {};
    } else if (inside && line.starts_with("  ") && !line.starts_with("  //")) {
      add_operators(line, found);
    } else if (inside && line.starts_with("}")) {
      EXPECT_EQ(found, expected) << path << ", kernel " << kernels;
      inside = false;
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

TEST(OperationCount, OfSamplesIsThatOfTheText) {
  EXPECT_GE(check_folder(SAMPLES_DIR), 30);
}

#ifdef ROBOTS_DIR
TEST(OperationCount, OfRobotsIsThatOfTheText) {
  EXPECT_GE(check_folder(ROBOTS_DIR), 100);
}
#endif

}  // namespace
}  // namespace robcogen::test
