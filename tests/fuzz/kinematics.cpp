#include "language/kinematics/document.h"
#include "survives_printing.h"

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  robcogen::fuzz::survives_printing(&robcogen::language::kinematics::parse, data, size);
  return 0;
}
