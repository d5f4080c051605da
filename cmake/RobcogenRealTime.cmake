# Checks that a hard real-time loop can call a generated library: a ctest of each library.
#
# cmake -D LIBRARY=file -D KERNELS=dir [-D LANGUAGE=C] -D OBJECTS=file,file… -D NM=program -D STACK_LIMIT=bytes
#       -P RobcogenRealTime.cmake
#
# - It calls only the functions of the list below.
# - Its kernels are straight-line code, without branches and loops: every call does the same operations. Large angles are
#   the exception: a kernel in lanes first tests for them, and calls the code without lanes.
# - The stack frames of its functions, which the compiler reports next to the object files (-fstack-usage), have constant or
#   bounded size. A kernel calls only its core, in the same unit; a long kernel or core calls its parts one after the
#   other, which call nothing else; a body over many states calls a kernel. Therefore the largest frame of a body, the two
#   largest of kernels and cores, and the largest of a part bound the stack, except that of sines, cosines and roots. Their
#   sum is at most STACK_LIMIT.
# - In C, kernels are the functions of the library. One that solves for columns calls a function that computes right-hand sides,
#   perhaps in parts; both have names with two underscores, and the bound has the largest of them twice. Loops over columns
#   run a fixed number of times.
#
# A check that is impossible, for lack of stack reports or of nm, is skipped with a message.
cmake_minimum_required(VERSION 3.22...3.25)

# Mathematics, copying and clearing of memory, detection of the processor (before main), stack protection, touching each
# page of a large frame on Windows, position-independent code.
set(allowed
    "sin|cos|tan|sincos|atan2|sqrt"
    "sinf|cosf|tanf|sincosf|atan2f|sqrtf"
    "memcpy|memset|memmove"
    "__cpu_model|__cpu_indicator_init"
    "__stack_chk_fail|__stack_chk_guard|__stack_chk_fail_local"
    "___chkstk_ms"
    "_GLOBAL_OFFSET_TABLE_")
# Symbols of the user's instrumentation, which also compares types of functions. Its frames are not those of the plain library.
set(instrumentation "__(asan|ubsan|msan|tsan|sanitizer|sancov|start___sancov|stop___sancov|gcov|llvm_profile|llvm_gcov)_.*|_ZTVN10__cxxabiv1.*")

# Sets `result` to the symbols of the library that `nm` lists with `options`.
function(read_symbols result)
  execute_process(
    COMMAND ${NM} -P ${ARGN} ${LIBRARY}
    OUTPUT_VARIABLE lines
    ERROR_VARIABLE error
    RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${NM} cannot read ${LIBRARY}: ${error}")
  endif()
  # `symbol letter …`, after a line that names the object.
  string(REGEX MATCHALL "(^|\n)[^ \n]+ [A-Za-z]" symbols "${lines}")
  list(TRANSFORM symbols REPLACE "\n" "")
  list(TRANSFORM symbols REPLACE " [A-Za-z]$" "")
  list(REMOVE_DUPLICATES symbols)
  list(SORT symbols)
  set(${result} "${symbols}" PARENT_SCOPE)
endfunction()

# Checks the symbols that the library calls, and sets `is_instrumented`.
function(check_symbols)
  set(is_instrumented OFF PARENT_SCOPE)
  if(NOT NM)
    message("symbols: not checked, nm is missing")
    return()
  endif()
  read_symbols(symbols --undefined-only)
  read_symbols(defined --defined-only)
  list(REMOVE_ITEM symbols ${defined})
  list(LENGTH symbols count)
  list(FILTER symbols EXCLUDE REGEX "^(${instrumentation})$")
  list(LENGTH symbols of_library)
  if(of_library LESS count)
    set(is_instrumented ON PARENT_SCOPE)
  endif()
  list(JOIN symbols " " names)
  message("symbols: ${names}")
  list(JOIN allowed "|" pattern)
  list(FILTER symbols EXCLUDE REGEX "^(${pattern})$")
  if(symbols)
    list(JOIN symbols ", " names)
    message(FATAL_ERROR "${LIBRARY} calls functions that a real-time loop must not call: ${names}")
  endif()
endfunction()

function(check_straight_lines)
  file(GLOB files ${KERNELS}/*.h)
  if(LANGUAGE STREQUAL "C")
    file(GLOB files ${KERNELS}/*.c)
    # Names and limits; what CasADi calls.
    list(FILTER files EXCLUDE REGEX "/(model|casadi)[.]c$")
  endif()
  if(NOT files)
    message(FATAL_ERROR "${KERNELS} has no kernels")
  endif()
  foreach(file IN LISTS files)
    file(READ ${file} text)
    string(REGEX REPLACE "//[^\n]*|\"[^\"\n]*\"" "" text "${text}")
    # The compiler decides by the scalar type whether limbs are computed in lanes, and columns are filled in lanes.
    string(REGEX REPLACE "if constexpr [(]robcogen::(kPrefersLanes<Scalar>|kFillsLanes<Scalar, [0-9]+>)[)]" "" text "${text}")
    # A kernel in lanes first tests whether angles are small.
    string(REGEX REPLACE "if [(]robcogen::are_small<[0-9]+>[(][A-Za-z0-9_]+[)][)]" "" text "${text}")
    # The loops in C over the columns that a function solves for, and over the rows of one, run a fixed number of times.
    string(REGEX REPLACE "for [(](; count > 0; --count|int row = 0; row < [0-9]+; [+][+]row)[)]" "" text "${text}")
    set(between "[^A-Za-z0-9_]")
    if(text MATCHES "${between}(if|for|while|do|switch|goto|throw|try|new|delete)${between}|[?]|&&|[|][|]")
      message(FATAL_ERROR "${file} is not straight-line code: ${CMAKE_MATCH_0}")
    endif()
  endforeach()
  list(LENGTH files count)
  message("kernels: ${count} files of straight-line code")
endfunction()

function(check_stack)
  set(largest 0)
  set(frames 0)
  string(REPLACE "," ";" objects "${OBJECTS}")
  foreach(object IN LISTS objects)
    cmake_path(REPLACE_EXTENSION object LAST_ONLY su OUTPUT_VARIABLE report)
    if(NOT EXISTS ${report})
      message("stack: not checked, the compiler wrote no ${report}")
      return()
    endif()
    # `file:line:column:function<tab>bytes<tab>kind`
    file(READ ${report} text)
    # Of function names, as gcc and clang write them, only `part` or `body` is kept.
    string(REGEX REPLACE "[^\n]*(kernel::[^\n\t]*parts::|6kernel[^\n\t]*5parts)[^\n\t]*\t" "part\t" text "${text}")
    if(LANGUAGE STREQUAL "C")
      string(REGEX REPLACE "[^\n]*:[A-Za-z0-9_]*[A-Za-z0-9]__[^\n\t]*\t" "part\t" text "${text}")
    endif()
    string(REGEX REPLACE "[^\n]*(batch::body::|5batch4body)[^\n\t]*\t" "body\t" text "${text}")
    string(REGEX MATCHALL "(part|body)?\t[0-9]+\t[a-z,]+" lines "${text}")
    set(first 0)
    set(second 0)
    set(part 0)
    set(body 0)
    foreach(line IN LISTS lines)
      math(EXPR frames "${frames} + 1")
      string(REGEX MATCH "[0-9]+" bytes "${line}")
      # dynamic,bounded: the size varies while arguments are pushed, up to these bytes.
      if(NOT is_instrumented AND NOT line MATCHES "\t(static|dynamic,bounded)$")
        message(FATAL_ERROR "${report}: a stack frame does not have a constant size")
      endif()
      if(line MATCHES "^(part|body)")
        if(bytes GREATER ${CMAKE_MATCH_1})
          set(${CMAKE_MATCH_1} ${bytes})
        endif()
      elseif(bytes GREATER first)
        set(second ${first})
        set(first ${bytes})
      elseif(bytes GREATER second)
        set(second ${bytes})
      endif()
    endforeach()
    if(LANGUAGE STREQUAL "C")
      math(EXPR part "2 * ${part}")
    endif()
    math(EXPR bytes "${body} + ${first} + ${second} + ${part}")
    if(bytes GREATER largest)
      set(largest ${bytes})
      cmake_path(GET object FILENAME unit)
    endif()
  endforeach()
  if(frames EQUAL 0)
    message(FATAL_ERROR "the compiler reports no stack frames of ${LIBRARY}")
  endif()
  if(is_instrumented)
    message("stack: at most ${largest} bytes, in instrumented code, which has no limit")
    return()
  endif()
  message("stack: ${largest} bytes at most, in ${unit}, of ${frames} functions; the limit is ${STACK_LIMIT}")
  if(largest GREATER STACK_LIMIT)
    message(FATAL_ERROR "a kernel of ${LIBRARY} with its caller and its parts may need stack frames of ${largest} bytes")
  endif()
endfunction()

check_symbols()
check_straight_lines()
check_stack()
