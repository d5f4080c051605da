// Rules for every generated file: requirements of MATLAB that Octave does not check, and of readers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "patterns.h"

namespace robcogen::octave {
namespace {

namespace fs = std::filesystem;

// The keyword lists of both programs (`iskeyword`).
const std::set<std::string> kKeywords = {
    "break",
    "case",
    "catch",
    "classdef",
    "continue",
    "do",
    "else",
    "elseif",
    "end",
    "endfor",
    "endfunction",
    "endif",
    "endswitch",
    "endwhile",
    "end_try_catch",
    "end_unwind_protect",
    "enumeration",
    "events",
    "for",
    "function",
    "global",
    "if",
    "methods",
    "otherwise",
    "parfor",
    "persistent",
    "properties",
    "return",
    "spmd",
    "switch",
    "try",
    "until",
    "unwind_protect",
    "unwind_protect_cleanup",
    "while"};

struct File {
  fs::path path;
  std::vector<std::string> lines;
  std::vector<std::string> code;  // without strings and comments; continued lines are joined
};

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

// Returns the line without comments and without the text in strings. A quote after a name or a bracket is a
// transposition.
std::string bare(const std::string& line) {
  std::string result;
  bool in_string = false;
  for (const char c : line) {
    const bool transposes = !result.empty() && (std::isalnum(static_cast<unsigned char>(result.back())) != 0 ||
                                                result.back() == ')' || result.back() == ']');
    if (c == '\'' && (in_string || !transposes)) in_string = !in_string;
    if (c == '%' && !in_string) break;
    if (!in_string) result += c;
  }
  return result;
}

std::vector<std::string> code(const std::vector<std::string>& lines) {
  std::vector<std::string> result;
  bool continues = false;
  for (const std::string& line : lines) {
    std::string text = bare(line);
    const std::size_t dots = text.find(" ...");
    const bool goes_on = dots != std::string::npos;
    if (goes_on) text.erase(dots);
    if (continues) {
      result.back() += text;
    } else if (text.find_first_not_of(' ') != std::string::npos) {
      result.push_back(text);
    }
    continues = goes_on;
  }
  return result;
}

// The folders with generated text, one for each run of the generator.
std::vector<fs::path> folders() {
  std::vector<fs::path> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(TEXT_DIR))
    if (entry.path().extension() == ".text") result.push_back(entry.path() / "matlab");
  std::sort(result.begin(), result.end());
  return result;
}

const std::vector<File>& files() {
  static const std::vector<File> all = [] {
    std::vector<File> list;
    for (const fs::path& folder : folders())
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".m") list.push_back({entry.path(), lines_of(entry.path()), {}});
    for (File& file : list) file.code = code(file.lines);
    return list;
  }();
  return all;
}

bool is_script(const File& file) {
  return file.path.filename() == "Contents.m";
}

TEST(Text, StandsThere) {
  EXPECT_GE(folders().size(), 18u);
  EXPECT_GE(files().size(), 1000u);
}

TEST(Text, LinesAreShortAndEndInNoBlank) {
  constexpr std::size_t kMaxColumns = 119;
  for (const File& file : files()) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      EXPECT_LE(line.size(), kMaxColumns) << file.path << ":" << i + 1;
      EXPECT_FALSE(line.ends_with(' ')) << file.path << ":" << i + 1;
      EXPECT_EQ(line.find('\t'), std::string::npos) << file.path << ":" << i + 1;
    }
  }
}

// The function may be followed only by the local functions that solve for columns in a loop.
TEST(Text, AFileIsOneFunctionOfItsName) {
  const std::string local = R"(function (?:\w+|\[[\w, ]+\]) = (?:right_sides|solution)\([\w, ]*\))";
  for (const File& file : files()) {
    if (is_script(file)) continue;
    const std::vector<std::string>& statements = file.code;
    ASSERT_GE(statements.size(), 3u) << file.path;
    const auto head = test::whole_match(statements.front(), R"(function (?:\w+|\[[\w, ]+\]) = (\w+)\([\w, ]*\))");
    ASSERT_TRUE(head) << file.path << ": " << statements.front();
    EXPECT_EQ((*head)[1], file.path.stem().string()) << file.path;
    EXPECT_EQ(file.lines.back(), "end") << file.path;
    for (std::size_t i = 1; i < statements.size(); ++i)
      EXPECT_TRUE(!statements[i].starts_with("function") || test::whole_match(statements[i], local))
          << file.path << ": " << statements[i];
  }
}

// `lookfor` searches the first comment line, and `help` ends at the first line that is not a comment.
TEST(Text, HelpComesFirst) {
  for (const File& file : files()) {
    if (is_script(file)) continue;
    std::string name = file.path.stem();
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    const auto first = std::find_if(
        file.lines.begin(), file.lines.end(), [](const std::string& line) { return line.starts_with("%"); });
    ASSERT_NE(first, file.lines.end()) << file.path;
    EXPECT_TRUE(first->starts_with("% " + name + "  ")) << file.path << ": " << *first;
    ASSERT_NE(first, file.lines.begin()) << file.path;
    EXPECT_TRUE(std::all_of(file.lines.begin(), first - 1, [](const std::string& line) {
      return line.ends_with("...");
    })) << file.path;
    const auto last = std::find(first, file.lines.end(), "");
    EXPECT_TRUE(std::all_of(first, last, [](const std::string& line) { return line.starts_with("%"); })) << file.path;
    EXPECT_TRUE(std::none_of(first, last, [](const std::string& line) {
      return line.find("Generated by") != std::string::npos;
    })) << file.path;
  }
}

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> result(1);
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
      result.back() += c;
    else if (!result.back().empty())
      result.emplace_back();
  }
  if (result.back().empty()) result.pop_back();
  return result;
}

// Checks arguments, results and every assigned name with its field.
TEST(Text, NoKeywordIsAName) {
  for (const File& file : files()) {
    for (const std::string& line : file.code) {
      const bool is_signature = line.starts_with("function "), is_loop = line.starts_with("  for ");
      const std::size_t equals = line.find(" = ");
      if (equals == std::string::npos) continue;
      const std::string assigned = line.substr(is_loop ? 6 : 0, equals - (is_loop ? 6 : 0));
      for (const std::string& name : words(is_signature ? line.substr(9) : assigned))
        EXPECT_FALSE(kKeywords.contains(name)) << file.path << ": " << line;
    }
  }
}

int assignments(const std::string& line) {
  int count = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (line[i] == '=' && line[i + 1] != '=' && std::string("=<>~").find(line[i - 1]) == std::string::npos) ++count;
  return count;
}

// Octave accepts these, MATLAB does not.
TEST(Text, IsNothingThatOctaveAloneTakes) {
  for (const File& file : files()) {
    for (const std::string& line : file.code) {
      for (const std::string foreign :
           {"+=", "-=", "*=", "/=", "++", "--", "**", "!", "#", "\"", "endfunction", "endif"})
        EXPECT_EQ(line.find(foreign), std::string::npos) << file.path << ": " << line;
      EXPECT_LE(assignments(line), 1) << file.path << ": " << line;
    }
  }
}

TEST(Text, IsWhatTheListOfFilesNames) {
  for (const fs::path& folder : folders()) {
    std::set<std::string> listed, found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".m")
        found.insert(fs::relative(entry.path(), folder.parent_path()).generic_string());
      if (entry.path().extension() != ".files") continue;
      for (const std::string& line : lines_of(entry.path())) listed.insert(line);
    }
    EXPECT_FALSE(found.empty()) << folder;
    EXPECT_EQ(found, listed) << folder;
  }
}

}  // namespace
}  // namespace robcogen::octave
