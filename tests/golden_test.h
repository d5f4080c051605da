// Comparison with expectations that are kept in files. A test program with golden_main.cpp rewrites these files, for
// review, if it is called with `--update`; a file that is as expected is not touched.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace robcogen::test {

// True if expectations are written instead of compared.
inline bool update_goldens = false;

// The lines that differ, with some lines around them, as `diff -u` prints them.
inline std::string difference(const std::string& expected, const std::string& found) {
  const auto lines = [](const std::string& text) {
    std::vector<std::string> result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) result.push_back(line);
    return result;
  };
  return testing::internal::edit_distance::CreateUnifiedDiff(lines(expected), lines(found));
}

// Compares a text with the expectation in the file, or calls `write`. `missing` completes the sentence "<file> …" if
// the file has no expectation.
inline void expect_golden(
    const std::filesystem::path& file,
    const std::optional<std::string>& expected,
    const std::string& found,
    const std::string& missing,
    const std::function<void()>& write) {
  if (expected == found) return;
  if (update_goldens) {
    write();
    GTEST_SKIP() << "wrote " << file.string();
  }
  if (!expected) {
    ADD_FAILURE() << file.string() << " " << missing << "; `--update` writes\n" << found;
  } else {
    ADD_FAILURE() << file.string() << " differs (-expected, +found):\n"
                  << difference(*expected, found)
                  << "If what was found is right, call this program with `--update` (the target update_goldens calls "
                  << "all) and review the change.";
  }
}

}  // namespace robcogen::test
