// robcogen: turns robot descriptions into code. Exit status 0 ok, 1 the input is wrong, 2 usage or input/output,
// 3 internal fault.
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

#include "command/command.h"
#include "command/output.h"
#include "command/usage.h"

namespace robcogen::command {
namespace {

Status run(int argc, char** argv) {
  CLI::App application("Generates kinematics and dynamics code for articulated robots.", "robcogen");
  application.set_version_flag("--version", fmt::format("robcogen {}", kVersion));
  application.require_subcommand(1);
  const std::vector<std::pair<const char*, Action>> actions = {
      {"generate", declare_generate(application)}, {"check", declare_check(application)},
      {"print", declare_print(application)},       {"ops", declare_ops(application)},
      {"eval", declare_eval(application)},         {"convert", declare_convert(application)}};
  try {
    application.parse(argc, argv);
  } catch (const CLI::Success& answer) {  // --help, --version
    std::ostringstream text;
    application.exit(answer, text, text);
    write_output(text.str());
    return ok;
  } catch (const CLI::ParseError& fault) {
    throw Failure{wrong_usage, explain(application, fault)};
  }
  for (const auto& [name, action] : actions)
    if (application.got_subcommand(name)) return action();
  return wrong_usage;
}

// What a user can bring about has a status of its own; the rest is a fault of the program.
Status run_and_report(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Failure& failure) {
    report(failure.message + "\n");
    return failure.status;
  } catch (const std::filesystem::filesystem_error& fault) {
    report(fmt::format("robcogen: error: {}\n", fault.what()));
    return wrong_usage;
  } catch (const std::bad_alloc&) {
    report("robcogen: error: out of memory\n");
    return wrong_usage;
  } catch (const std::exception& fault) {
    report(fmt::format("robcogen: internal fault: {}\nPlease report this, with the model.\n", fault.what()));
    return internal_fault;
  }
}

}  // namespace
}  // namespace robcogen::command

int main(int argc, char** argv) {
  using namespace robcogen::command;
  prepare_streams();
  return close_streams(run_and_report(argc, argv));
}
