// Messages as a user sees them: a document must produce exactly the messages in its file (none if it is correct).
// golden.h describes these files, golden_test.h how they are updated.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "golden.h"
#include "golden_test.h"
#include "patterns.h"
#include "support/source.h"

namespace robcogen::test {

inline std::string contents(const std::filesystem::path& path) {
  return bytes_of(path);
}

// A source that messages refer to by its file name alone.
inline std::shared_ptr<const Source> source_of_file(const std::filesystem::path& path) {
  return std::make_shared<Source>(path.filename().string(), contents(path));
}

// The same for the document in a golden file.
inline std::shared_ptr<const Source> source_of_golden(const std::filesystem::path& path) {
  return std::make_shared<Source>(path.filename().string(), golden_at(path).document);
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

// The name of the test for this document: its stem.
inline std::string test_name(const testing::TestParamInfo<std::filesystem::path>& document) {
  std::string name = document.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

// Compares the messages with those in the file, or writes them.
inline void expect_messages(const std::string& messages, const std::filesystem::path& file) {
  Golden golden = golden_at(file);
  const std::optional<std::string> expected = golden.messages;
  expect_golden(file, expected, messages, "has no line '==== messages ====' with the expected messages after it", [&] {
    golden.messages = messages;
    std::ofstream(file, std::ios::binary) << text_of(golden);
  });
}

// The first capture group of each match.
inline std::set<std::string> matches(const std::string& text, const std::string& pattern) {
  std::set<std::string> result;
  for (const Match& found : all_matches(text, pattern)) result.insert(found[1]);
  return result;
}

// The codes in the messages of the folder's documents.
inline std::set<std::string> shown_codes(const std::filesystem::path& folder, const std::set<std::string>& extensions) {
  const std::string rendered = R"re((?:error|warning|note): .*\[([a-z0-9-]+)\]\n)re";
  std::set<std::string> shown;
  for (const std::filesystem::path& file : files(folder, extensions))
    shown.merge(matches(golden_at(file).messages.value_or(""), rendered));
  return shown;
}

// Checks that a document of the folder shows each of these codes, that there are more than `at_least` codes, and that
// each file of the folder is such a document; another file would never be checked.
inline void expect_documents(
    const std::set<std::string>& codes,
    const std::filesystem::path& folder,
    const std::set<std::string>& extensions,
    std::size_t at_least = 30) {
  EXPECT_GT(codes.size(), at_least) << "the codes were not found in the sources";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    EXPECT_TRUE(entry.is_directory() || extensions.contains(entry.path().extension().string()))
        << entry.path() << " is not a document of these tests";
  const std::set<std::string> shown = shown_codes(folder, extensions);
  for (const std::string& code : codes) EXPECT_TRUE(shown.contains(code)) << "no document yields [" << code << "]";
}

}  // namespace robcogen::test
