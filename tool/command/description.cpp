#include "command/description.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

namespace robcogen::command {
namespace {

// The values that the description of a check lists: `TEXT:{cpp,matlab} ...`
std::vector<std::string> values_of(const std::string& type) {
  std::vector<std::string> values;
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return values;
  for (std::size_t begin = open + 1; begin < close;) {
    const std::size_t end = std::min(type.find(',', begin), close);
    values.push_back(type.substr(begin, end - begin));
    begin = end + 1;
  }
  return values;
}

constexpr const char* kExample = "  robcogen generate arm.kindsl -o generated";

// Each line is a command of its own.
const std::vector<std::pair<const char*, const char*>> kExamples = {
    {"generate",
     "  robcogen generate arm.kindsl -o generated --algorithms inverse_dynamics,jacobians\n"
     "  robcogen generate arm.urdf -o generated --snap-angles --language c matlab --name left_arm"},
    {"check", "  robcogen check arm.kindsl arm.dtdsl"},
    {"print",
     "  robcogen print arm.kindsl\n"
     "  robcogen print arm.kindsl --program inverse_dynamics"},
    {"ops", "  robcogen ops arm.kindsl --algorithms inverse_dynamics,joint_space_inertia"},
    {"eval", "  echo '{\"q\": [0.3, 0.1]}' | robcogen eval arm.kindsl gravity_forces"},
    {"convert",
     "  robcogen convert arm.urdf arm_of_urdf.kindsl\n"
     "  robcogen convert arm.kindsl arm_of_document.urdf"},
    {"draw", "  robcogen draw arm.kindsl --q 0.3,0.1 --pattern -o arm.svg"},
    {"view", "  robcogen view arm.kindsl -o arm.html"},
    {"language-server", "  robcogen language-server --stdio"},
    {"completions",
     "  source <(robcogen completions bash)    # bash, zsh\n"
     "  robcogen completions fish | source     # fish"},
    {"manual", "  robcogen manual > robcogen.1"}};

std::string in_help(const std::string& remarks, const std::string& examples) {
  const bool is_one = examples.find('\n') == std::string::npos;
  return remarks + (remarks.empty() ? "" : "\n\n") + (is_one ? "Example:\n" : "Examples:\n") + examples;
}

std::vector<OptionDescription> options_of(const CLI::App& subcommand) {
  std::vector<OptionDescription> result;
  for (const CLI::Option* option : subcommand.get_options()) {
    OptionDescription d;
    d.is_positional = option->get_positional();
    if (!option->get_snames().empty()) d.short_name = "-" + option->get_snames().front();
    d.description = option->get_description();
    d.values = values_of(option->get_type_name());
    d.takes_value = option->get_items_expected_max() > 0;
    if (d.is_positional) {
      d.name = option->get_name(true);
      result.push_back(d);
    }
    for (const std::string& name : option->get_lnames()) {
      d.name = "--" + name;
      result.push_back(d);
    }
  }
  return result;
}

}  // namespace

ProgramDescription describe(const CLI::App& application) {
  ProgramDescription program;
  for (const CLI::App* subcommand : application.get_subcommands(nullptr))
    program.subcommands.push_back(
        {subcommand->get_name(), subcommand->get_description(), options_of(*subcommand), subcommand->get_footer()});
  program.footer = application.get_footer();
  return program;
}

void add_examples(CLI::App& application) {
  application.footer(in_help("robcogen COMMAND --help lists the options of a command.", kExample));
  for (const auto& [name, examples] : kExamples) {
    CLI::App* const subcommand = application.get_subcommand(name);
    subcommand->footer(in_help(subcommand->get_footer(), examples));
  }
}

}  // namespace robcogen::command
