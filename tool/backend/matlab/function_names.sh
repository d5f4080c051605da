#!/bin/sh
# function_names.sh DIRECTORY: writes functions.inc, the functions of Octave, as a list that C++ reads. The list of the
# project is made by `function_names.sh tool/backend/matlab`; names that other versions have may be added.
set -e
out=${1:?usage: function_names.sh DIRECTORY}
octave-cli --no-gui --norc --no-history --eval "printf('%s\n', [__builtins__(); __list_functions__()]{:})" |
  LC_ALL=C grep -E '^[A-Za-z][A-Za-z0-9_]*$' | LC_ALL=C sort -u | awk '
    BEGIN { print "// Functions of Octave. Written by function_names.sh." }
    { item = "\"" $0 "\","
      if (line != "" && length(line) + 1 + length(item) > 118) { print line; line = "" }
      line = line (line == "" ? "" : " ") item }
    END { if (line != "") print line }' >"$out/functions.inc"
