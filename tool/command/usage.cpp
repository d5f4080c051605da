#include "command/usage.h"

#include <fmt/format.h>

#include "support/diagnostics.h"

namespace robcogen::command {
namespace {

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument.front() == '-';
}

std::vector<std::string> subcommand_names(const CLI::App& application) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : application.get_subcommands(nullptr)) names.push_back(subcommand->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& subcommand) {
  std::vector<std::string> names;
  for (const CLI::Option* option : subcommand.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string command_of(const CLI::App& application) {
  const std::vector<CLI::App*> chosen = application.get_subcommands();
  return chosen.empty() ? "robcogen" : "robcogen " + chosen.front()->get_name();
}

std::string unknown_subcommand(const CLI::App& application, const std::string& word) {
  const std::vector<std::string> names = subcommand_names(application);
  return with_hint(
      fmt::format("'{}' is not a subcommand; those are {}", word, fmt::join(names, ", ")), did_you_mean(word, names));
}

// `--strct`, or `--strct=3`.
std::string unknown_option(const CLI::App& application, const std::string& argument) {
  const std::vector<CLI::App*> chosen = application.get_subcommands();
  const std::string name = argument.substr(0, argument.find('='));
  return with_hint(
      fmt::format("'{}' is not an option of {}", name, command_of(application)),
      did_you_mean(name, option_names(chosen.empty() ? application : *chosen.front())));
}

// Of what the parser left over, the first word that explains the fault; empty when there is none.
std::string explain_leftover(const CLI::App& application) {
  const std::vector<CLI::App*> chosen = application.get_subcommands();
  const std::vector<std::string> left = (chosen.empty() ? application : *chosen.front()).remaining();
  for (const std::string& argument : left)
    if (is_option(argument)) return unknown_option(application, argument);
  if (left.empty()) return "";
  if (chosen.empty()) return unknown_subcommand(application, left.front());
  return fmt::format("{} takes no further argument '{}'", command_of(application), left.front());
}

}  // namespace

std::string with_hint(const std::string& message, const std::string& hint) {
  return hint.empty() ? message : message + "\nhint: " + hint;
}

CLI::Validator one_of(std::vector<std::string> words) {
  const std::string description = fmt::format("{{{}}}", fmt::join(words, ","));
  const auto check = [words = std::move(words)](const std::string& word) -> std::string {
    if (std::find(words.begin(), words.end(), word) != words.end()) return "";
    return with_hint(fmt::format("'{}' is not one of {}", word, fmt::join(words, ", ")), did_you_mean(word, words));
  };
  return {check, description};
}

std::string explain(const CLI::App& application, const CLI::ParseError& fault) {
  std::string message;
  const auto code = static_cast<CLI::ExitCodes>(fault.get_exit_code());
  if (code == CLI::ExitCodes::ExtrasError || code == CLI::ExitCodes::RequiredError)
    message = explain_leftover(application);
  if (message.empty()) message = fault.what();
  return fmt::format("robcogen: error: {}\nTry '{} --help'.", message, command_of(application));
}

}  // namespace robcogen::command
