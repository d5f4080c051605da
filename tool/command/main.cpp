// robcogen: turns robot descriptions into code. Exit status 0 ok, 1 the input is wrong, 2 usage or input/output,
// 3 internal fault.
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <new>

#include "command/command_line.h"
#include "command/output.h"

namespace robcogen::command {
namespace {

// Faults of the input or of the usage have their own statuses; other exceptions are internal faults.
Status run_and_report(int argc, char** argv) {
  try {
    return parse_command_line(argc, argv)();
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
