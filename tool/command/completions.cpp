#include "command/completions.h"

#include <fmt/format.h>

namespace robcogen::command {
namespace {

struct Completion {
  std::string name;  // `--language`
  std::string description;
  std::vector<std::string> values;  // of which one must be given; empty: anything, such as a file
  bool takes_value = false;
};

// What the description of a check lists: `TEXT:{cpp,matlab} ...`
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

std::vector<Completion> options_of(const CLI::App& subcommand) {
  std::vector<Completion> result;
  for (const CLI::Option* option : subcommand.get_options())
    for (const std::string& name : option->get_lnames())
      result.push_back(
          {"--" + name, option->get_description(), values_of(option->get_type_name()),
           option->get_items_expected_max() > 0});
  return result;
}

std::vector<const CLI::App*> subcommands_of(const CLI::App& application) {
  const std::vector<const CLI::App*> all =
      application.get_subcommands([](const CLI::App* subcommand) { return !subcommand->get_name().empty(); });
  return all;
}

// A function that both bash and, with bashcompinit, zsh call. Where it knows nothing, the shell completes files.
std::string in_bash(const CLI::App& application) {
  std::string commands, values, options;
  for (const CLI::App* subcommand : subcommands_of(application)) {
    commands += (commands.empty() ? "" : " ") + subcommand->get_name();
    std::string names;
    for (const Completion& option : options_of(*subcommand)) {
      names += (names.empty() ? "" : " ") + option.name;
      if (!option.values.empty())
        values += fmt::format(
            "    \"{} {}\") words=\"{}\" ;;\n", subcommand->get_name(), option.name, fmt::join(option.values, " "));
    }
    options += fmt::format("    {}) [[ $word == -* ]] && words=\"{}\" ;;\n", subcommand->get_name(), names);
  }
  return fmt::format(
      "_robcogen() {{\n"
      "  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" command=\"${{COMP_WORDS[1]}}\" words=\"\"\n"
      "  COMPREPLY=()\n"
      "  case \"$command\" in\n{}  esac\n"
      "  case \"$command ${{COMP_WORDS[COMP_CWORD-1]}}\" in\n{}  esac\n"
      "  if ((COMP_CWORD == 1)); then words=\"{}\"; fi\n"
      "  if [[ -n $words ]]; then COMPREPLY=($(compgen -W \"$words\" -- \"$word\")); fi\n"
      "}}\n"
      "complete -o default -F _robcogen robcogen\n",
      options, values, commands);
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return result + "'";
}

std::string in_fish(const CLI::App& application) {
  std::string text;
  for (const CLI::App* subcommand : subcommands_of(application)) {
    const std::string& name = subcommand->get_name();
    text += fmt::format(
        "complete -c robcogen -n __fish_use_subcommand -a {} -d {}\n", name, quoted(subcommand->get_description()));
    for (const Completion& option : options_of(*subcommand)) {
      std::string line = fmt::format(
          "complete -c robcogen -n '__fish_seen_subcommand_from {}' -l {} -d {}", name, option.name.substr(2),
          quoted(option.description));
      if (option.takes_value) line += " -r";
      if (!option.values.empty())
        line += fmt::format(" -f -a {}", quoted(fmt::format("{}", fmt::join(option.values, " "))));
      text += line + "\n";
    }
  }
  return text;
}

}  // namespace

const std::vector<std::string>& shells() {
  static const std::vector<std::string> all = {"bash", "zsh", "fish"};
  return all;
}

std::string completions(const CLI::App& application, const std::string& shell) {
  if (shell == "fish") return in_fish(application);
  const std::string start =
      shell == "zsh" ? "autoload -U +X compinit && compinit\nautoload -U +X bashcompinit && bashcompinit\n" : "";
  return start + in_bash(application);
}

}  // namespace robcogen::command
