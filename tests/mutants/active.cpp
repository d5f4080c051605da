#include "active.h"

#include <cstdlib>

namespace robcogen::mutants {

bool is(int mutant) {
  static const char* const text = std::getenv("ROBCOGEN_MUTANT");
  static const int active = text == nullptr ? 0 : std::atoi(text);
  return mutant == active;
}

}  // namespace robcogen::mutants
