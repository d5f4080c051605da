# Compiler flags for generated code, as in the CMake functions; other scripts read this file.
# shellcheck shell=bash

# The arguments of the CMake command that this expression finds in a file of cmake/.
flags_in() { # file expression
  local flags
  flags=$(sed -n "s/$2/\\1/p" "$(dirname "${BASH_SOURCE[0]}")/../cmake/$1")
  if [[ -z $flags ]]; then
    echo "bench/flags.sh: no such flags in cmake/$1: $2" >&2
    return 1
  fi
  echo "$flags"
}

# Flags for gcc, except the optimisation level.
flags_of_gcc() {
  flags_in Robcogen.cmake '^ *set(of_gcc \(.*\))$'
}

# Flags with which gcc schedules the kernels of the highest level.
flags_of_order() {
  flags_in RobcogenProcessors.cmake '^.* COMPILE_OPTIONS \(-fschedule-insns .*\))$'
}

is_gcc() { # compiler
  "$1" --version | grep -q "Free Software Foundation"
}
