#!/usr/bin/env bash
# Instructions of one call of inverse dynamics, forward dynamics and inertia matrix, sines and cosines included, counted
# by callgrind: a figure of speed without noise.
#
#     bench/instructions.sh GENERATOR NAME=MODEL …
#
# generates the code of each model (.kindsl, or .urdf with its angles snapped), compiles it for AVX2, and counts. Where
# RobCoGen 5.0.1 (on its own HyQ, with a floating base, and iiwa 14) has figures under that NAME, hyq or iiwa14, it prints
# how many times ours these are. Environment: CXX (g++), CXXFLAGS (-O2 -mavx2 -mfma and the flags of the CMake function).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=flags.sh
source "$here/flags.sh"

published_of() {
  case $1 in
    hyq) echo "6378 15518 5971" ;;
    iiwa14) echo "3146 7265 3016" ;;
  esac
}

# The instructions of a run with this number of calls.
instructions_of_run() { # program function calls
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 | sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}

# The instructions of a call are the difference between runs with more and with fewer calls.
instructions_of_call() { # program function
  local few=200 many=1200 start end
  start=$(instructions_of_run "$1" "$2" $few)
  end=$(instructions_of_run "$1" "$2" $many)
  if [[ -n $start && -n $end ]]; then
    echo $(((end - start) / (many - few)))
  fi
}

count_model() { # name model folder
  local options=()
  if [[ $2 == *.urdf ]]; then
    options=(--snap-angles)
  fi
  # The generator's messages about the model do not matter here.
  if ! "$generator" generate "$2" -o "$3" --name subject "${options[@]}" \
    --algorithms inverse_dynamics forward_dynamics joint_space_inertia 2>"$3/remarks"; then
    cat "$3/remarks" >&2
    return 1
  fi
  local flags="-O2 -mavx2 -mfma" of_gcc
  if is_gcc "${CXX:-g++}"; then
    of_gcc=$(flags_of_gcc)
    flags+=" $of_gcc"
  fi
  # shellcheck disable=SC2086  # words
  ${CXX:-g++} -std=c++17 ${CXXFLAGS:-$flags} -I"$3" -I"$here/../runtime/include" \
    $(pkg-config --cflags eigen3 2>/dev/null || echo -I/usr/include/eigen3) \
    "$here/instructions.cpp" $(find "$3/subject" -name '*.cpp' | sort) -o "$3/instructions"
  local published row=0 function count
  read -r -a published <<<"$(published_of "$1")"
  for function in inverse_dynamics forward_dynamics joint_space_inertia inverse_dynamics_base_free; do
    count=$(instructions_of_call "$3/instructions" "$function")
    if [[ -z $count || $count == 0 ]]; then
      continue # a fixed base
    fi
    if [[ -n ${published[row]:-} ]]; then
      printf '%-12s %-28s %8d %8d %6sx\n' "$1" "$function" "$count" "${published[row]}" \
        "$((published[row] * 10 / count / 10)).$((published[row] * 10 / count % 10))"
    else
      printf '%-12s %-28s %8d %8s %7s\n' "$1" "$function" "$count" - -
    fi
    row=$((row + 1))
  done
}

if (($# < 2)); then
  sed -n '2,10s/^# \{0,1\}//p' "$0"
  exit 2
fi
generator=$1
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
printf '%-12s %-28s %8s %8s %7s\n' robot function ours 5.0.1 times
for argument; do
  name=${argument%%=*}
  mkdir "$scratch/$name"
  count_model "$name" "${argument#*=}" "$scratch/$name"
done
