# Compiles single.cpp, which has kernels in float, and checks that the assembly contains nothing of double precision: no
# instruction on x86-64, and no routine of the compiler's library on a Cortex-M4F, which computes in float only.
#
# cmake -D COMPILER=path -D PROCESSOR=x86|cortex_m4f -D INCLUDES=dir,dir -D WORK=file -P check_single.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

# Uses the headers of this machine for a processor without an operating system: only declarations are read from them.
function(borrow_headers result)
  execute_process(COMMAND ${COMPILER} -E -v -x c++ /dev/null OUTPUT_QUIET ERROR_VARIABLE text)
  string(REGEX MATCHALL "\n /[^ \n]+" directories "${text}")
  list(TRANSFORM directories REPLACE "\n " "-isystem;")
  list(FILTER directories EXCLUDE REGEX "isystem;.*/clang/")
  # glibc requires this file on all machines but its own.
  file(WRITE ${WORK}.include/gnu/stubs-32.h "")
  set(${result} -nostdinc++ ${directories} -isystem ${WORK}.include PARENT_SCOPE)
endfunction()

set(options -std=c++17 -O2 -fno-exceptions)
if(PROCESSOR STREQUAL "x86")
  set(double "\t(v?cvt(ss2sd|ps2pd|sd2ss|pd2ps|si2sd|dq2pd)|v?(add|sub|mul|div|sqrt)[sp]d|vf[a-z0-9]*[sp]d)[ \t]")
else()
  set(double "__aeabi_(d[a-z0-9]+|cd[a-z]+|f2d|i2d|ui2d|l2d|ul2d)")
  list(APPEND options -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard)
  if(COMPILER MATCHES "clang")
    borrow_headers(headers)
    list(APPEND options --target=thumbv7em-none-eabihf ${headers})
  else()
    list(APPEND options -mthumb)
  endif()
  file(WRITE ${WORK}.cpp "#include <array>\n#include <cmath>\n#include <cstdint>\n")
  execute_process(
    COMMAND ${COMPILER} ${options} -fsyntax-only ${WORK}.cpp OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message("skipped: ${COMPILER} has no standard headers for a Cortex-M4F")
    return()
  endif()
endif()

list_includes(includes)
run(output ${COMPILER} ${options} ${includes} -S ${CMAKE_CURRENT_LIST_DIR}/single.cpp -o ${WORK}.s)
file(READ ${WORK}.s text)
if(NOT text MATCHES "forward_dynamics_of_leg")
  message(FATAL_ERROR "no function in ${WORK}.s")
endif()
string(REGEX MATCHALL "${double}" found "${text}")
list(LENGTH found count)
if(count GREATER 0)
  list(REMOVE_DUPLICATES found)
  message(FATAL_ERROR "kernels in float compute in double, ${count} times: ${found}")
endif()
