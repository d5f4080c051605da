// URDFs as test input.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "import/urdf.h"

namespace robcogen::test {

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::shared_ptr<const Source> source(const std::filesystem::path& path) {
  return std::make_shared<Source>(path.filename().string(), contents(path));
}

// Files of a folder with this extension, sorted; none when there is no such folder.
inline std::vector<std::filesystem::path> files(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::filesystem::path> result;
  if (!std::filesystem::is_directory(folder)) return result;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == extension) result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

// The first groups of all matches.
inline std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::set<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) result.insert((*it)[1]);
  return result;
}

// The name of a test of this document.
inline std::string test_name(const testing::TestParamInfo<std::string>& document) {
  std::string name = document.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

// The names of the documents of a folder, without this extension.
inline std::vector<std::string> stems(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::string> result;
  for (const std::filesystem::path& file : files(folder, extension)) result.push_back(file.stem().string());
  return result;
}

// Compares messages with the file, or writes it: see messages_test.cpp.
inline void expect_messages(const std::string& messages, const std::filesystem::path& expected) {
  if (std::getenv("ROBCOGEN_ACCEPT_MESSAGES") != nullptr) {
    std::ofstream(expected, std::ios::binary) << messages;
    GTEST_SKIP() << "wrote " << expected;
  }
  ASSERT_TRUE(exists(expected)) << expected << " is missing; the messages are\n" << messages;
  EXPECT_EQ(messages, contents(expected));
}

// Each of these codes must stand in an `.expected` file of the folder.
inline void expect_documents(const std::set<std::string>& codes, const std::filesystem::path& folder) {
  EXPECT_GT(codes.size(), 30u) << "the codes were not found in the sources";
  std::set<std::string> shown;
  for (const std::filesystem::path& file : files(folder, ".expected"))
    shown.merge(matches(contents(file), std::regex(R"re((?:error|warning|note): .*\[([a-z-]+)\])re")));
  for (const std::string& code : codes) EXPECT_TRUE(shown.contains(code)) << "no document yields [" << code << "]";
}

struct Imported {
  std::optional<model::KinematicTree> tree;
  Diagnostics diagnostics;

  std::vector<const Diagnostic*> of_code(const std::string& code) const {
    std::vector<const Diagnostic*> result;
    for (const Diagnostic& d : diagnostics.all())
      if (d.code == code) result.push_back(&d);
    return result;
  }
};

inline Imported imported(const std::string& text, const import::UrdfOptions& options = {}) {
  Imported result;
  result.tree = import::urdf(std::make_shared<Source>("robot.urdf", text), options, result.diagnostics);
  return result;
}

// A robot that must be read without errors.
inline model::KinematicTree tree_of(const std::string& text, const import::UrdfOptions& options = {}) {
  Imported result = imported(text, options);
  EXPECT_TRUE(result.tree) << result.diagnostics.render();
  return result.tree.value_or(model::KinematicTree());
}

}  // namespace robcogen::test
