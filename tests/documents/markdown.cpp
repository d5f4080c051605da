#include "markdown.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace robcogen::test {

namespace fs = std::filesystem;

namespace {

bool is_fence(const std::string& line) {
  return line.starts_with("```");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Calls `text(line)` for lines outside code blocks and `code(line)` for lines inside them, including the opening fence.
template <class Text, class Code>
void walk(const std::string& guide, Text text, Code code) {
  bool is_code = false;
  for (const std::string& line : lines_of(guide)) {
    if (is_fence(line)) {
      is_code = !is_code;
      if (is_code) code(line);
    } else if (is_code) {
      code(line);
    } else {
      text(line);
    }
  }
}

}  // namespace

fs::path source_folder() {
  return ROBCOGEN_SOURCE_DIR;
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> guides() {
  std::vector<fs::path> found;
  for (auto at = fs::recursive_directory_iterator(source_folder()); at != fs::recursive_directory_iterator(); ++at) {
    const std::string name = at->path().filename().string();
    if (at->is_directory() && (name.starts_with(".") || name.starts_with("build"))) at.disable_recursion_pending();
    if (at->path().extension() == ".md") found.push_back(fs::relative(at->path(), source_folder()));
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<CodeBlock> code_blocks(const std::string& guide) {
  std::vector<CodeBlock> blocks;
  std::string section;
  walk(
      guide,
      [&](const std::string& line) {
        if (line.starts_with("## ")) section = line.substr(3);
      },
      [&](const std::string& line) {
        if (is_fence(line)) {
          blocks.push_back({section, line.substr(3), ""});
        } else {
          blocks.back().text += line + "\n";
        }
      });
  return blocks;
}

std::string without_code(const std::string& guide) {
  std::string text;
  walk(
      guide,
      [&](const std::string& line) {
        bool is_code = false;
        for (const char c : line) {
          if (c == '`') is_code = !is_code;
          if (!is_code && c != '`') text += c;
        }
        text += '\n';
      },
      [](const std::string&) {});
  return text;
}

std::vector<std::string> anchors(const std::string& guide) {
  std::vector<std::string> found;
  std::map<std::string, int> count;
  const auto heading = [&](const std::string& line) {
    const std::size_t level = line.find_first_not_of('#');
    if (level == 0 || level == std::string::npos || line[level] != ' ') return;
    std::string anchor;
    for (const char c : line.substr(level + 1)) {
      const auto byte = static_cast<unsigned char>(c);
      if (std::isalnum(byte) || c == '-' || c == '_' || byte >= 0x80) anchor += static_cast<char>(std::tolower(byte));
      if (c == ' ') anchor += '-';
    }
    const int earlier = count[anchor]++;
    found.push_back(earlier == 0 ? anchor : anchor + "-" + std::to_string(earlier));
  };
  walk(guide, heading, [](const std::string&) {});
  return found;
}

std::vector<std::vector<std::string>> table_rows(const std::string& guide) {
  std::vector<std::vector<std::string>> rows;
  const auto row = [&](const std::string& line) {
    if (!line.starts_with("|")) return;
    rows.emplace_back();
    for (std::size_t at = 1, end; (end = line.find('|', at)) != std::string::npos; at = end + 1) {
      const std::size_t first = std::min(line.find_first_not_of(' ', at), end);
      const std::size_t last = std::max(line.find_last_not_of(' ', end - 1) + 1, first);
      rows.back().push_back(line.substr(first, last - first));
    }
  };
  walk(guide, row, [](const std::string&) {});
  return rows;
}

fs::path scratch(const std::string& name) {
  return fs::temp_directory_path() / ("robcogen-" + name + "-" + std::to_string(::getpid()));
}

std::string output_of(const std::string& command, int& status) {
  std::string output;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  char buffer[4096];
  for (std::size_t read; (read = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) output.append(buffer, read);
  const int closed = pclose(pipe);
  status = WIFEXITED(closed) ? WEXITSTATUS(closed) : -1;
  return output;
}

fs::path code_of_hyl(const std::string& name, const std::string& options) {
  const fs::path folder = scratch(name);
  int status = 0;
  const std::string output = output_of(
      "'" ROBCOGEN_TOOL "' generate '" ROBCOGEN_SOURCE_DIR "/robots/hyl/hyl.kindsl' --name hyl -o '" + folder.string() +
          "' " + options,
      status);
  EXPECT_EQ(status, 0) << output;
  return folder;
}

}  // namespace robcogen::test
