// Messages as a user sees them: a document bad/<name>.<extension> must produce exactly bad/<name>.expected (nothing if
// the document is correct).
//
// If ROBCOGEN_ACCEPT_MESSAGES is set in the environment, the current messages are written to those files for review.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/source.h"

namespace robcogen::test {

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A source that messages refer to by its file name alone.
inline std::shared_ptr<const Source> source_of_file(const std::filesystem::path& path) {
  return std::make_shared<Source>(path.filename().string(), contents(path));
}

// Files of a folder with one of these extensions, sorted; an empty list if the folder does not exist.
inline std::vector<std::filesystem::path> files(
    const std::filesystem::path& folder,
    const std::set<std::string>& extensions) {
  std::vector<std::filesystem::path> result;
  if (!std::filesystem::is_directory(folder)) return result;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (extensions.contains(entry.path().extension().string())) result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

// The names of the documents in a folder, without their extensions.
inline std::vector<std::string> stems(const std::filesystem::path& folder, const std::set<std::string>& extensions) {
  std::vector<std::string> result;
  for (const std::filesystem::path& file : files(folder, extensions)) result.push_back(file.stem().string());
  return result;
}

// The name of the test for this document: its stem.
inline std::string test_name(const testing::TestParamInfo<std::string>& document) {
  std::string name = document.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

// Compares the messages with the file, or writes the file.
inline void expect_messages(const std::string& messages, const std::filesystem::path& expected) {
  if (std::getenv("ROBCOGEN_ACCEPT_MESSAGES") != nullptr) {
    std::ofstream(expected, std::ios::binary) << messages;
    GTEST_SKIP() << "wrote " << expected;
  }
  ASSERT_TRUE(exists(expected)) << expected << " is missing; the messages are\n" << messages;
  EXPECT_EQ(messages, contents(expected));
}

// The first capture group of each match.
inline std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) result.insert((*it)[1]);
  return result;
}

// The codes in the `.expected` files of a folder.
inline std::set<std::string> shown_codes(const std::filesystem::path& folder) {
  const std::regex rendered(R"re((?:error|warning|note): .*\[([a-z0-9-]+)\]\n)re");
  std::set<std::string> shown;
  for (const std::filesystem::path& file : files(folder, {".expected"})) shown.merge(matches(contents(file), rendered));
  return shown;
}

// Checks that a document of the folder shows each of these codes, and that there are more than `at_least` codes.
inline void expect_documents(
    const std::set<std::string>& codes,
    const std::filesystem::path& folder,
    std::size_t at_least = 30) {
  EXPECT_GT(codes.size(), at_least) << "the codes were not found in the sources";
  const std::set<std::string> shown = shown_codes(folder);
  for (const std::string& code : codes) EXPECT_TRUE(shown.contains(code)) << "no document yields [" << code << "]";
}

}  // namespace robcogen::test
