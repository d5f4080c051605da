#include <fmt/format.h>

#include <cstdio>

#include "command/command.h"
#include "pass/passes.h"

namespace robcogen::command {

ErrorFormat format_of(const std::string& name) {
  return name == "msvc" ? ErrorFormat::msvc : ErrorFormat::gnu;
}

void declare_error_format(CLI::App& subcommand, std::string& format) {
  subcommand.add_option("--error-format", format, "How messages name places: gnu or msvc")
      ->check(CLI::IsMember({"gnu", "msvc"}));
}

void ModelOptions::declare(CLI::App& subcommand) {
  passes = pass::names();
  subcommand.add_option("model", model, "Robot document (.kindsl)")->required();
  subcommand.add_option("--desired", desired, "Desired transforms and Jacobians (.dtdsl)");
  subcommand.add_flag("--strict", strict, "Warnings of the desired-transforms document are errors");
  subcommand.add_option("--passes", passes, "Which passes run: a comma-separated list, or none")
      ->delimiter(',')
      ->check(CLI::IsMember([] {
        std::vector<std::string> names = pass::names();
        names.push_back("none");
        return names;
      }()));
  declare_error_format(subcommand, error_format);
}

std::optional<std::filesystem::path> ModelOptions::desired_path() const {
  return desired.empty() ? std::nullopt : std::optional<std::filesystem::path>(desired);
}

std::optional<Robot> ModelOptions::load() const {
  Diagnostics diagnostics;
  std::optional<Robot> robot = load_robot(model, desired_path(), strict, diagnostics);
  fmt::print(stderr, "{}", diagnostics.render(format_of(error_format)));
  return robot;
}

}  // namespace robcogen::command
