#!/usr/bin/env bash
# A fresh machine: installs what is missing, configures, builds, and runs.
#
#     cmake/bootstrap.sh demo              builds some robots and runs programs that use them
#     cmake/bootstrap.sh install PREFIX    builds the generator and installs it with its CMake package
#     cmake/bootstrap.sh test              builds everything and runs the whole test suite
#
# On Debian and its relatives the missing packages are installed by name, with sudo unless this is root. Elsewhere they
# are listed, and the build continues without them.
set -euo pipefail
prefix=${2:+$(realpath --canonicalize-missing "$2")}
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_packages=(g++ cmake ninja-build libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev liburdfdom-dev)
test_packages=(make ccache clang-14 clang-format-14 libgtest-dev librapidcheck-dev libbenchmark-dev
  libnlopt-dev liborocos-kdl-dev libmujoco-dev libdart-dev libdart-utils-urdf-dev octave maxima nodejs chromium
  gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm g++-aarch64-linux-gnu qemu-user
  python3-dev python3-numpy python3-matplotlib mypy groff-base neovim emacs-nox elpa-eglot dpkg-dev
  colcon python3-colcon-cmake python3-colcon-ros)

usage() {
  sed -n '2,9s/^# \{0,1\}//p' cmake/bootstrap.sh
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

run_tests() {
  install_missing "${build_packages[@]}" "${test_packages[@]}"
  use_compiler_cache
  run cmake --preset ci
  run cmake --build --preset ci
  run ctest --preset ci
}

case "${1:-}${prefix:+ PREFIX}" in
  demo) demo ;;
  "install PREFIX") install_project ;;
  test) run_tests ;;
  -h | --help) usage ;;
  *)
    usage >&2
    exit 2
    ;;
esac
