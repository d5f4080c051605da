# What a generated library must be so that a hard real-time loop can call it: a ctest of each.
#
# cmake -D LIBRARY=file -D KERNELS=dir -D OBJECTS=file,file… -D NM=program -D STACK_LIMIT=bytes -P RobcogenRealTime.cmake
#
# - It calls nothing but the functions of the list below.
# - Its kernels are straight-line code, with no branch and no loop: every call does the same operations. But for large
#   angles: a kernel in lanes leaves these, before all else, to the way one by one.
# - Its functions' stack frames, which the compiler reports beside the object files (-fstack-usage), are of constant or
#   bounded size. A kernel calls no other but its core, of the same unit, and either calls, where it is long, its parts,
#   one after the other, which call none; a body over many states calls a kernel. So the largest frame of a body, the two
#   largest of kernels and cores, and the largest of a part are the stack that one uses at most, besides that of sines,
#   cosines and roots. They are no larger than STACK_LIMIT.
#
# What the program cannot see, as the compiler reports no stack use or there is no nm, it says and leaves out.
cmake_minimum_required(VERSION 3.25)

# Mathematics, blocks of memory that compilers copy and clear, what the processor can do (found out before main), stack
# protection, position-independent code.
set(allowed
    "sin|cos|tan|sincos|sqrt"
    "sinf|cosf|tanf|sincosf|sqrtf"
    "memcpy|memset|memmove"
    "__cpu_model|__cpu_indicator_init"
    "__stack_chk_fail|__stack_chk_guard|__stack_chk_fail_local"
    "_GLOBAL_OFFSET_TABLE_")
# What the user's own instrumentation adds. Its frames say nothing about those of the plain library.
set(instrumentation "__(asan|ubsan|msan|tsan|sanitizer|gcov|llvm_profile|llvm_gcov)_.*")

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

# Sets `is_instrumented` beside.
function(check_symbols)
  set(is_instrumented OFF PARENT_SCOPE)
  if(NOT NM)
    message("symbols: not checked, there is no nm")
    return()
  endif()
  read_symbols(symbols --undefined-only)
  read_symbols(defined --defined-only)
  list(REMOVE_ITEM symbols ${defined})
  list(LENGTH symbols count)
  list(FILTER symbols EXCLUDE REGEX "^${instrumentation}$")
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
    message(FATAL_ERROR "${LIBRARY} calls what a real-time loop must not: ${names}")
  endif()
endfunction()

function(check_straight_lines)
  file(GLOB files ${KERNELS}/*.h)
  if(NOT files)
    message(FATAL_ERROR "there are no kernels in ${KERNELS}")
  endif()
  foreach(file IN LISTS files)
    file(READ ${file} text)
    string(REGEX REPLACE "//[^\n]*|\"[^\"\n]*\"" "" text "${text}")
    # Limbs in lanes or one by one: the compiler decides, by the scalar type.
    string(REGEX REPLACE "if constexpr [(]robcogen::kPrefersLanes<Scalar>[)]([^}]*)} else" "\\1}" text "${text}")
    # And before what it does in lanes: are angles small?
    string(REGEX REPLACE
      "if constexpr [(]robcogen::kPrefersLanes<Scalar>[)] {[ \n]*if [(]robcogen::are_small<[0-9]+>[(][A-Za-z0-9_]+[)][)] {([^}]*)}"
      "{\\1" text "${text}")
    set(between "[^A-Za-z0-9_]")
    if(text MATCHES "${between}(if|else|for|while|do|switch|goto|throw|try|new|delete)${between}|[?]|&&|[|][|]")
      message(FATAL_ERROR "${file} is no straight-line code: ${CMAKE_MATCH_0}")
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
    # Of functions as gcc and as clang writes them, only whether they are parts or bodies is kept.
    string(REGEX REPLACE "[^\n]*(kernel::[^\n\t]*parts::|6kernel[^\n\t]*5parts)[^\n\t]*\t" "part\t" text "${text}")
    string(REGEX REPLACE "[^\n]*(batch::body::|5batch4body)[^\n\t]*\t" "body\t" text "${text}")
    string(REGEX MATCHALL "(part|body)?\t[0-9]+\t[a-z,]+" lines "${text}")
    set(first 0)
    set(second 0)
    set(part 0)
    set(body 0)
    foreach(line IN LISTS lines)
      math(EXPR frames "${frames} + 1")
      string(REGEX MATCH "[0-9]+" bytes "${line}")
      # dynamic,bounded: it moves while arguments are pushed, and never beyond these bytes.
      if(NOT is_instrumented AND NOT line MATCHES "\t(static|dynamic,bounded)$")
        message(FATAL_ERROR "${report}: a frame is not of constant size")
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
    math(EXPR bytes "${body} + ${first} + ${second} + ${part}")
    if(bytes GREATER largest)
      set(largest ${bytes})
      cmake_path(GET object FILENAME unit)
    endif()
  endforeach()
  if(frames EQUAL 0)
    message(FATAL_ERROR "the compiler reports no frame of ${LIBRARY}")
  endif()
  if(is_instrumented)
    message("stack: ${largest} bytes at most, of instrumented code, which has no limit")
    return()
  endif()
  message("stack: ${largest} bytes at most, in ${unit}, of ${frames} functions; the limit is ${STACK_LIMIT}")
  if(largest GREATER STACK_LIMIT)
    message(FATAL_ERROR "a kernel of ${LIBRARY} with what calls it and what it calls may need stack frames of ${largest} bytes")
  endif()
endfunction()

check_symbols()
check_straight_lines()
check_stack()
