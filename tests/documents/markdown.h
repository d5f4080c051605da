// Guides, and their contents.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robcogen::test {

std::filesystem::path source_folder();

std::string read_text(const std::filesystem::path& path);

// Every guide of the project, relative to its folder.
std::vector<std::filesystem::path> guides();

struct CodeBlock {
  std::string section;   // title of the second level that it stands below; empty before the first
  std::string language;  // the word after the fence
  std::string text;
};

std::vector<CodeBlock> code_blocks(const std::string& guide);

// The guide without its code blocks and without `code` in lines.
std::string without_code(const std::string& guide);

// Places that a link may name, as GitHub makes them of headings.
std::vector<std::string> anchors(const std::string& guide);

// Rows of all tables, as cells without blanks around them.
std::vector<std::vector<std::string>> table_rows(const std::string& guide);

// A path for temporary files of one test: no other process has it.
std::filesystem::path scratch(const std::string& name);

// Runs a command of the shell and returns its output, errors included; sets its exit status.
std::string output_of(const std::string& command, int& status);

}  // namespace robcogen::test
