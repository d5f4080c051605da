#include "language/kinematics/document.h"
#include "survives_printing.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  robcogen::fuzz::survives_printing(&robcogen::language::kinematics::parse, data, size);
  return 0;
}
