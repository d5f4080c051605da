// robcogen: turns robot descriptions into code. Exit status 0 ok, 1 the input is wrong, 2 usage or input/output,
// 3 internal fault.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <utility>
#include <vector>

#include "command/command.h"

int main(int argc, char** argv) {
  using namespace robcogen::command;
  CLI::App application("Generates kinematics and dynamics code for articulated robots.", "robcogen");
  application.set_version_flag("--version", fmt::format("robcogen {}", kVersion));
  application.require_subcommand(1);
  application.failure_message(CLI::FailureMessage::help);
  const std::vector<std::pair<const char*, Action>> actions = {
      {"generate", declare_generate(application)}, {"check", declare_check(application)},
      {"print", declare_print(application)},       {"ops", declare_ops(application)},
      {"eval", declare_eval(application)},         {"convert", declare_convert(application)}};
  try {
    application.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return application.exit(help);
  } catch (const CLI::ParseError& fault) {
    fmt::print(stderr, "robcogen: error: {}\nTry 'robcogen --help'.\n", fault.what());
    return wrong_usage;
  }
  try {
    for (const auto& [name, run] : actions)
      if (application.got_subcommand(name)) return run();
  } catch (const Failure& failure) {
    fmt::print(stderr, "{}\n", failure.message);
    return failure.status;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "robcogen: internal fault: {}\nPlease report this, with the model.\n", fault.what());
    return internal_fault;
  }
  return wrong_usage;
}
