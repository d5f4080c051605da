#include "command/completions.h"

#include <fmt/format.h>

namespace robcogen::command {
namespace {

// A function that bash calls, and zsh with bashcompinit. If it has no suggestion, the shell completes files.
std::string in_bash(const ProgramDescription& program) {
  std::string commands, values, options;
  for (const SubcommandDescription& subcommand : program.subcommands) {
    commands += (commands.empty() ? "" : " ") + subcommand.name;
    std::string names;
    for (const OptionDescription& option : subcommand.options) {
      if (option.is_positional) continue;
      names += (names.empty() ? "" : " ") + option.name;
      if (!option.values.empty())
        values += fmt::format(
            "    \"{} {}\") words=\"{}\" ;;\n", subcommand.name, option.name, fmt::join(option.values, " "));
    }
    options += fmt::format("    {}) [[ $word == -* ]] && words=\"{}\" ;;\n", subcommand.name, names);
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

std::string in_fish(const ProgramDescription& program) {
  std::string text;
  for (const SubcommandDescription& subcommand : program.subcommands) {
    const std::string& name = subcommand.name;
    text += fmt::format(
        "complete -c robcogen -n __fish_use_subcommand -a {} -d {}\n", name, quoted(subcommand.description));
    for (const OptionDescription& option : subcommand.options) {
      if (option.is_positional) continue;
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

std::string completions(const ProgramDescription& program, const std::string& shell) {
  if (shell == "fish") return in_fish(program);
  if (shell == "bash") return in_bash(program);
  // This also works where zsh finds functions by their file names: the first completion calls the file, which must
  // complete at once.
  return "#compdef robcogen\n(( $+functions[compdef] )) || { autoload -U +X compinit && compinit }\n"
         "autoload -U +X bashcompinit && bashcompinit\n" +
         in_bash(program) + "if [[ $funcstack[1] == _robcogen ]]; then _bash_complete -o default -F _robcogen; fi\n";
}

}  // namespace robcogen::command
