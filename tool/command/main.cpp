// robcogen: turns robot descriptions into code. Exit status 0 ok, 1 the input is wrong, 2 usage or input/output,
// 3 internal fault.
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <limits>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

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

// Programs are made and dropped by the hundred. Memory that goes back to the system between them comes back as page
// faults, a fifth of the generator's time.
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_TOP_PAD, 16 << 20);
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace
}  // namespace robcogen::command

int main(int argc, char** argv) {
  using namespace robcogen::command;
  keep_freed_memory();
  prepare_streams();
  return close_streams(run_and_report(argc, argv));
}
