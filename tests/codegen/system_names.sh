#!/bin/sh
# system_names.sh DIRECTORY: writes the names that the headers of the standard library and of POSIX use, and the names
# that compilers predefine:
#
#   macros.inc   macros, and the types and variables that a local name would shadow
#   globals.inc  functions, structures and enumerators outside of namespaces, which no namespace can have as its name
#
# The lists of the same names in tool/backend/common must cover them. Names that begin with '_' or contain "__" are left
# out, because no identifier of generated code does.
set -e
out=${1:?usage: system_names.sh DIRECTORY}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LC_ALL=C

cpp_headers='algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv chrono
  cinttypes climits clocale cmath compare complex concepts condition_variable csetjmp csignal cstdarg cstddef cstdint
  cstdio cstdlib cstring ctime cuchar cwchar cwctype deque exception execution filesystem format forward_list fstream
  functional future initializer_list iomanip ios iosfwd iostream istream iterator latch limits list locale map memory
  memory_resource mutex new numbers numeric optional ostream queue random ranges ratio regex scoped_allocator semaphore
  set shared_mutex source_location span sstream stack stdexcept stop_token streambuf string string_view syncstream
  system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray variant vector
  version'
c_headers='aio.h alloca.h arpa/inet.h assert.h complex.h cpio.h ctype.h dirent.h dlfcn.h endian.h errno.h fcntl.h fenv.h
  float.h fmtmsg.h fnmatch.h ftw.h getopt.h glob.h grp.h iconv.h immintrin.h inttypes.h iso646.h langinfo.h libgen.h
  limits.h locale.h malloc.h math.h monetary.h mqueue.h net/if.h netdb.h netinet/in.h netinet/tcp.h nl_types.h poll.h
  pthread.h pwd.h regex.h sched.h search.h semaphore.h setjmp.h signal.h spawn.h stdarg.h stdbool.h stddef.h stdint.h
  stdio.h stdlib.h string.h strings.h sys/ioctl.h sys/ipc.h sys/mman.h sys/msg.h sys/param.h sys/resource.h sys/select.h
  sys/sem.h sys/shm.h sys/socket.h sys/stat.h sys/statvfs.h sys/sysmacros.h sys/time.h sys/times.h sys/types.h sys/uio.h
  sys/un.h sys/utsname.h sys/wait.h syslog.h tar.h termios.h tgmath.h time.h uchar.h ulimit.h unistd.h utime.h utmpx.h
  values.h wchar.h wctype.h wordexp.h'

includes() {
  for header in "$@"; do
    printf '#if __has_include(<%s>)\n#include <%s>\n#endif\n' "$header" "$header"
  done
}
includes $cpp_headers $c_headers >"$work/all.cpp"
includes $c_headers >"$work/posix.cpp"
includes complex.h math.h stdalign.h stdatomic.h stdnoreturn.h threads.h >"$work/c_alone.c"

for compiler in g++ clang++; do
  command -v $compiler >"$work/which" || continue
  for standard in gnu++17 gnu++20; do
    $compiler -std=$standard -w -dM -E "$work/all.cpp"
  done
  $compiler -x c -std=gnu17 -w -dM -E "$work/c_alone.c"
done | sed -n 's/^#define \([A-Za-z0-9_]*\).*/\1/p' >"$work/macros"

# The names outside of namespaces: in the dump of the syntax tree, declarations directly below the translation unit,
# below `extern "C"`, and below enumerations without a scope.
if command -v clang++ >"$work/which"; then
  clang++ -std=gnu++20 -w -fsyntax-only -Xclang -ast-dump "$work/posix.cpp" | awk '
    {
      match($0, /^[ |`-]*/)
      depth = RLENGTH / 2
      kind = substr($0, RLENGTH + 1)
      sub(/ .*/, "", kind)
      encloses[depth] = kind ~ /^(TranslationUnit|LinkageSpec|Enum)Decl$/
      for (outer = 0; outer < depth; ++outer) if (!encloses[outer]) next
      name = ""
      if (kind ~ /^(Function|Typedef|TypeAlias|Var|EnumConstant)Decl$/ && match($0, / [A-Za-z0-9_]+ \047/))
        name = substr($0, RSTART + 1, RLENGTH - 3)
      else if (kind == "CXXRecordDecl" && match($0, / (struct|union|class) [A-Za-z0-9_]+/)) {
        name = substr($0, RSTART + 1, RLENGTH - 1)
        sub(/.* /, "", name)
      } else if (kind == "EnumDecl" && $NF !~ /[^A-Za-z0-9_]/)
        name = $NF
      if (name != "") print (kind ~ /^(Typedef|TypeAlias|Var)Decl$/ ? "macros" : "globals"), name
    }' >"$work/declared"
  sed -n 's/^macros //p' "$work/declared" >>"$work/macros"
  sed -n 's/^globals //p' "$work/declared" >"$work/globals"
fi

# Prints the names, sorted and quoted.
list() {
  grep -v -e '^_' -e '__' "$1" | grep -v -x -e definition | sort -u | sed 's/.*/"&",/'
}
touch "$work/globals"
list "$work/macros" >"$out/macros.inc"
grep -v -x -F -f "$work/macros" "$work/globals" >"$work/others" || true
list "$work/others" >"$out/globals.inc"
