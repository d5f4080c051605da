// The guides and their contents.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robcogen::test {

std::filesystem::path source_folder();

std::string read_text(const std::filesystem::path& path);

// Every guide of the project, relative to the project's folder.
std::vector<std::filesystem::path> guides();

struct CodeBlock {
  std::string section;   // second-level heading above it; empty before the first
  std::string language;  // the word after the fence
  std::string text;
};

std::vector<CodeBlock> code_blocks(const std::string& guide);

// The guide without its code blocks and inline `code`.
std::string without_code(const std::string& guide);

// The anchors that GitHub generates from headings.
std::vector<std::string> anchors(const std::string& guide);

// The rows of all tables, as cells without surrounding blanks.
std::vector<std::vector<std::string>> table_rows(const std::string& guide);

// A path for temporary files that no other process uses.
std::filesystem::path scratch(const std::string& name);

// Runs a shell command, sets its exit status, and returns its output, errors included.
std::string output_of(const std::string& command, int& status);

// The folder scratch(name), with the code that the generator prints for the robot hyl with these options. A test fails
// if the generator does.
std::filesystem::path code_of_hyl(const std::string& name, const std::string& options = "");

}  // namespace robcogen::test
