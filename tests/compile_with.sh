#!/bin/sh
# Compiles with another compiler what the build would compile with gcc:
#
#     compile_with.sh GCC [LAUNCHER] COMPILER GCC arguments…
#
# clang takes half of gcc's time for test programs. The arguments that only gcc understands are left out.
gcc=$1
shift
for argument; do
  shift
  case $argument in
    "$gcc" | --param=* | -Wno-restrict | -Winvalid-pch) continue ;;
    -fno-tree-* | -fno-dse | -frename-registers | -fno-code-hoisting | -fno-thread-jumps) continue ;;
    -fno-schedule-insns2 | -fschedule-insns | -fschedule-insns2 | -fsched-pressure) continue ;;
    # clang would include the old precompiled header while it makes the new one.
    *.gch) rm -f "$argument" ;;
  esac
  set -- "$@" "$argument"
done
exec "$@" -fpch-instantiate-templates -Wno-unused-command-line-argument
