// The command line as data, derived from its own declaration, for completions and the manual page.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace robcogen::command {

struct OptionDescription {
  std::string short_name;  // `-o`, or empty
  std::string name;        // `--output`; of a positional argument, `model`
  std::string description;
  std::vector<std::string> values;  // the allowed values; empty: anything, such as a file
  bool takes_value = false;
  bool is_positional = false;
};

std::vector<OptionDescription> options_of(const CLI::App& subcommand);

std::vector<const CLI::App*> subcommands_of(const CLI::App& application);

// Adds examples to the end of the help of every subcommand and of the program itself.
void add_examples(CLI::App& application);

}  // namespace robcogen::command
