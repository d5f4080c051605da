// The command line as data, derived from its own declaration, for completions and the manual page. Only the sources
// that declare the command line, or read the declaration, include the headers of CLI11: they take seconds to compile.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace robcogen::command {

struct OptionDescription {
  std::string short_name;  // `-o`, or empty
  std::string name;        // `--output`; of a positional argument, `model`
  std::string description;
  std::vector<std::string> values;  // the allowed values; empty: anything, such as a file
  bool takes_value = false;
  bool is_positional = false;
};

struct SubcommandDescription {
  std::string name;
  std::string description;
  std::vector<OptionDescription> options;
  std::string footer;  // remarks and examples
};

struct ProgramDescription {
  std::vector<SubcommandDescription> subcommands;
  std::string footer;
};

ProgramDescription describe(const CLI::App& application);

// Adds examples to the end of the help of every subcommand and of the program itself.
void add_examples(CLI::App& application);

}  // namespace robcogen::command
