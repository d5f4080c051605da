// The command line as data, from its own declaration: for completions and the manual page.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace robcogen::command {

struct OptionDescription {
  std::string short_name;  // `-o`, or empty
  std::string name;        // `--output`; of what has a place instead of a name, `model`
  std::string description;
  std::vector<std::string> values;  // of which one must be given; empty: anything, such as a file
  bool takes_value = false;
  bool is_positional = false;
};

std::vector<OptionDescription> options_of(const CLI::App& subcommand);

std::vector<const CLI::App*> subcommands_of(const CLI::App& application);

// Gives every subcommand, and the program itself, examples at the end of its help.
void add_examples(CLI::App& application);

}  // namespace robcogen::command
