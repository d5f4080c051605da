// Which mutant runs.
#pragma once

namespace robcogen::mutants {

// The number in the environment variable ROBCOGEN_MUTANT; without it none is active.
bool is(int mutant);

}  // namespace robcogen::mutants
