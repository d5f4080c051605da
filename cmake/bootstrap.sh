#!/usr/bin/env bash
# A fresh machine: installs what is missing, configures, builds, and runs.
#
#     cmake/bootstrap.sh demo              builds some robots and runs programs that use them
#     cmake/bootstrap.sh install PREFIX    builds the generator and installs it with its CMake package
#     cmake/bootstrap.sh wheel             makes the Python wheel of this platform, and the source distribution, in build/wheel
#     cmake/bootstrap.sh sources FOLDER    brings the sources of libraries that wheels link statically, from Debian
#     cmake/bootstrap.sh test              builds and runs the tests of every change: about 20 minutes
#     cmake/bootstrap.sh test everything   builds and runs every test, for releases: hours
#
# On Debian and its relatives the missing packages are installed by name, with sudo unless this is root. Elsewhere they
# are listed, and the build continues without them.
set -euo pipefail
command=${1:-}
argument=${2:-}
prefix=${argument:+$(realpath --canonicalize-missing "$argument")}
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_packages=(g++ cmake ninja-build libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev liburdfdom-dev)
source_packages=(fmtlib urdfdom urdfdom-headers tinyxml console-bridge cli11 nlohmann-json3)
test_packages=(ccache clang-format-14 libgtest-dev librapidcheck-dev liborocos-kdl-dev libmujoco-dev octave maxima nodejs
  chromium python3-dev python3-numpy groff-base ocl-icd-opencl-dev pocl-opencl-icd)
more_test_packages=(make clang-14 libbenchmark-dev libnlopt-dev libdart-dev libdart-utils-urdf-dev valgrind musl-tools
  gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm g++-aarch64-linux-gnu qemu-user
  python3-matplotlib mypy doxygen neovim emacs-nox elpa-eglot dpkg-dev colcon python3-colcon-cmake python3-colcon-ros python3-venv
  g++-mingw-w64-x86-64-posix wine wine64 g++-11 clang-16 clang-19 libc++-16-dev libc++abi-16-dev)

usage() {
  sed -n '2,12s/^# \{0,1\}//p' cmake/bootstrap.sh
}

is_installed() {
  [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

install_missing() {
  if ! command -v apt-get >/dev/null; then
    echo "bootstrap: this system has no apt-get; install these packages (Debian names):" "$@" >&2
    return
  fi
  local missing=() package
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then
    return
  fi
  local as_root=()
  if ((EUID != 0)); then
    as_root=(sudo)
  fi
  run "${as_root[@]}" apt-get update
  run "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "${missing[@]}"
}

# Prints a command and runs it.
run() {
  echo "+ $*"
  "$@"
}

# Every CMake run below, including those of the tests, takes the compiler cache from the environment.
use_compiler_cache() {
  if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}
    # Files with precompiled headers are cached too.
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
  fi
}

demo() {
  install_missing "${build_packages[@]}"
  use_compiler_cache
  run cmake --preset demo
  run cmake --build --preset demo --target robcogen_demo
}

install_project() {
  install_missing "${build_packages[@]}"
  use_compiler_cache
  run cmake --preset release
  run cmake --build --preset release --target robcogen
  run cmake --install build/release --prefix "$prefix"
}

# The sources of libraries, in folders that are called like the library and its version. apt verifies them; the lists of source
# packages stay in a folder of their own.
bring_sources() {
  local folder=$1
  if ! command -v apt-get >/dev/null; then
    echo "bootstrap: this system has no apt-get; unpack the sources of these libraries in $folder:" "${source_packages[@]}" >&2
    return 1
  fi
  install_missing dpkg-dev
  mkdir -p "$folder/lists/partial"
  . /etc/os-release
  echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" >"$folder/sources.list"
  local options=(-o "Dir::Etc::SourceList=$folder/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o "Dir::State::Lists=$folder/lists" -o APT::Sandbox::User=)
  run apt-get "${options[@]}" update
  (cd "$folder" && run apt-get "${options[@]}" source "${source_packages[@]}")
  rm -r "$folder/lists" "$folder/sources.list"
}

# The wheel and the source distribution of a release.
make_wheel() {
  install_missing "${build_packages[@]}" python3
  use_compiler_cache
  if [[ ! -d build/sources ]]; then
    bring_sources "$PWD/build/sources"
  fi
  run cmake --preset wheel
  run cmake --build --preset wheel --target robcogen_wheel robcogen_sdist
}

# Compilers and test programs get memory in large pieces and keep it: page faults would take a twentieth of their time.
keep_freed_memory() {
  export MALLOC_TOP_PAD_=$((16 << 20)) MALLOC_MMAP_THRESHOLD_=$((32 << 20)) MALLOC_TRIM_THRESHOLD_=$((1 << 30))
}

# Builds a preset and runs its tests; prints the summary of the run and keeps it in the build folder. Fails if a test does.
run_tests() {
  local preset=$1
  shift
  install_missing "${build_packages[@]}" "$@"
  use_compiler_cache
  keep_freed_memory
  local results=build/$preset/results.xml failed=0
  run cmake --preset "$preset"
  run cmake --build --preset "$preset"
  run ctest --preset "$preset" --output-junit "$PWD/$results" || failed=$?
  times >"build/$preset/times"  # a subshell has times of its own
  summary "$preset" "$results" | tee "build/$preset/summary.txt"
  return "$failed"
}

# What a run did: build steps, tests, processor time, and what was skipped and why.
summary() {
  echo
  echo "summary of the preset $1"
  awk '!/^#/ && !($5 in seen) { seen[$5]; ++steps } END { print "  build steps        " steps }' "build/$1/.ninja_log"
  awk 'NR == 2 { split($1, own, /[ms]/); split($2, kernel, /[ms]/)
    printf "  %-18s %d\n", "processor seconds", 60 * (own[1] + kernel[1]) + own[2] + kernel[2] }' "build/$1/times"
  awk -F'"' '/<testcase / { name = $2 } /<skipped / { print "  skipped: " name ": " $2 }' "$2"
  awk -F'"' '/^\t(tests|failures|skipped)=/ { n[$1] = $2 } /<testcase/ { exit } END {
    t = n["\ttests="]; f = n["\tfailures="]; s = n["\tskipped="]
    print t - f - s " passed, " f " failed, " s " skipped" }' "$2"
}

case "$command${argument:+ ARGUMENT}" in
  demo) demo ;;
  "install ARGUMENT") install_project ;;
  wheel) make_wheel ;;
  "sources ARGUMENT") bring_sources "$prefix" ;;
  test) run_tests test "${test_packages[@]}" ;;
  "test ARGUMENT")
    if [[ $argument != everything ]]; then
      usage >&2
      exit 2
    fi
    if command -v apt-get >/dev/null && [[ ! -d build/sources ]]; then
      bring_sources "$PWD/build/sources"
    fi
    run_tests everything "${test_packages[@]}" "${more_test_packages[@]}"
    ;;
  -h | --help) usage ;;
  *)
    usage >&2
    exit 2
    ;;
esac
