#!/usr/bin/env bash
# Times kernels of one state, as a library has them for AVX2, against each other: of several generators, or with several
# flags of the compiler.
#
#     bench/paired.sh MODEL GENERATOR[,FLAG…] …
#
# For each function and variant: cycles of a call and how much of those of the first variant that is, for calls in a row
# and for calls of which each waits for the result of the one before; medians over 5 processes, whose code stands at
# other addresses, of medians over 21 interleaved rounds of 256 states. Each process loads copies of the libraries: the
# pages of one file may lie so that a large kernel takes three times as long, in every process. MODEL: a robot without
# parameters; of a .urdf, angles are snapped. Inverse dynamics of a floating base: its acceleration is given.
# Environment: CXX (g++), OPTIONS (further ones of the generators, such as --floating-base).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=flags.sh
source "$here/flags.sh"

if (($# < 2)); then
  sed -n '2,13s/^# \{0,1\}//p' "$0"
  exit 2
fi
model=$1
shift
cxx=${CXX:-g++}
flags="-O2 -mavx2 -mfma -fno-math-errno"
if is_gcc "$cxx"; then
  of_gcc=$(flags_of_gcc) of_order=$(flags_of_order)
  flags+=" $of_gcc $of_order"
else
  flags+=" -ffp-contract=fast"
fi
if ! { grep -qw avx2 /proc/cpuinfo && grep -qw fma /proc/cpuinfo; } 2>/dev/null; then
  echo "bench/paired.sh: this processor has no AVX2, or the system does not say" >&2
  exit 77
fi
read -ra options <<<"${OPTIONS:-}"
if [[ $model == *.urdf ]]; then
  options+=(--snap-angles)
fi
# "HyL: 3 joints, fixed base; …"
title=$("${1%%,*}" ops "$model" "${options[@]}" --algorithms joint_space_inertia 2>/dev/null | sed -n 1p || true)
size=$(sed -n 's/.*: \([0-9]*\) joints.*/\1/p' <<<"$title")
unit=paired_kernels.cpp
if [[ $title == *floating\ base* ]]; then
  size=$((size + 6)) unit=paired_kernels_floating.cpp
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
libraries=()
for variant; do
  folder=$scratch/$((${#libraries[@]} + 1))
  mkdir "$folder"
  generator=${variant%%,*}
  own=${variant#"$generator"}
  # The generator's messages about the model do not matter here.
  if ! "$generator" generate "$model" -o "$folder" --name subject "${options[@]}" --processors baseline avx2 \
    --algorithms inverse_dynamics forward_dynamics joint_space_inertia 2>"$folder/remarks"; then
    cat "$folder/remarks" >&2
    exit 1
  fi
  # shellcheck disable=SC2086  # words
  "$cxx" -std=c++17 $flags ${own//,/ } -fPIC -shared -I"$folder" -I"$here/../runtime/include" \
    "$here/$unit" -o "$folder/kernels.so"
  libraries+=("$folder/kernels.so")
done
"$cxx" -std=c++17 -O2 "$here/paired.cpp" -o "$scratch/paired" -ldl

middle() { # column, of the lines of one variant
  sort -n -k "$1" | awk -v column="$1" '{ value[NR] = $column } END { print value[int((NR + 1) / 2)] }'
}

printf '%-20s %-8s %10s %6s %12s %6s\n' function variant "in a row" ratio "one by one" ratio
for function in inverse_dynamics forward_dynamics joint_space_inertia; do
  : >"$scratch/times"
  for process in 1 2 3 4 5; do
    copies=()
    for library in "${libraries[@]}"; do
      copies+=("${library%.so}_$function$process.so")
      cp "$library" "${copies[-1]}"
    done
    "$scratch/paired" "$size" "$function" "${copies[@]}" >>"$scratch/times"
  done
  for i in $(seq ${#libraries[@]}); do
    grep "^$i " "$scratch/times" >"$scratch/lines"
    printf '%-20s %-8s %10.0f %6.3f %12.0f %6.3f\n' "$function" "$i" "$(middle 2 <"$scratch/lines")" \
      "$(middle 3 <"$scratch/lines")" "$(middle 4 <"$scratch/lines")" "$(middle 5 <"$scratch/lines")"
  done
done
