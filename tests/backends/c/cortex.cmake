# The arm ur.kindsl in single precision on a Cortex-M4F or -M7: it compiles without a warning, its code is small and
# calls no double-precision routine, and its results are those of this machine.
#
# cmake -D GCC=arm-none-eabi-gcc -D QEMU=qemu-system-arm -D REQUIRED=bool -D TOOL=robcogen -D SOURCE_DIR=dir -D FOLDER=dir
#       -D PROCESSOR=m4|m7 -P cortex.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${SOURCE_DIR}/../../package/steps.cmake)
foreach(program GCC QEMU)
  if(NOT ${program})
    if(REQUIRED)
      message(FATAL_ERROR "there is no ${program} for ARM: install gcc-arm-none-eabi, libnewlib-arm-none-eabi, qemu-system-arm")
    endif()
    message(STATUS "skipped: there is no ${program} for ARM")
    return()
  endif()
endforeach()

file(REMOVE_RECURSE ${FOLDER})
run(output ${TOOL} generate ${SOURCE_DIR}/ur.kindsl --name ur --language c -o ${FOLDER})
# The processors of these boards have floating-point units for single precision only.
set(machine -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16)
set(board mps2-an386)
if(PROCESSOR STREQUAL "m7")
  set(machine -mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-sp-d16)
  set(board mps2-an500)
endif()
set(strict -std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror)
set(objects "")
file(GLOB sources ${FOLDER}/c/ur_c/*.c)
foreach(source IN LISTS sources)
  cmake_path(GET source STEM name)
  run(output ${GCC} ${machine} ${strict} -Os -ffp-contract=fast -ffunction-sections -fdata-sections -I${FOLDER}/c -c ${source} -o ${FOLDER}/${name}.o)
  list(APPEND objects ${FOLDER}/${name}.o)
endforeach()
run(output ${GCC} ${machine} -std=gnu99 -Wall -Wextra -Werror -Os -I${FOLDER}/c -c ${SOURCE_DIR}/cortex.c -o ${FOLDER}/main.o)
run(output ${GCC} ${machine} -nostartfiles -Wl,--gc-sections -T ${SOURCE_DIR}/cortex.ld ${FOLDER}/main.o ${objects} -lm -lc -lgcc
    -o ${FOLDER}/arm.elf)

string(REGEX REPLACE "gcc[^/]*$" "nm" nm ${GCC})
run(symbols ${nm} --print-size ${FOLDER}/arm.elf)
string(REGEX MATCH "[0-9a-f]+ ([0-9a-f]+) T ur_inverse_dynamicsf\n" found "${symbols}")
if(NOT found)
  message(FATAL_ERROR "the program has no ur_inverse_dynamicsf:\n${symbols}")
endif()
math(EXPR size "0x${CMAKE_MATCH_1}")
message(STATUS "ur_inverse_dynamicsf: ${size} bytes")
if(size GREATER 1300)
  message(FATAL_ERROR "ur_inverse_dynamicsf takes ${size} bytes, more than 1300")
endif()
if(symbols MATCHES "(__aeabi_d[a-z0-9]*|__aeabi_f2d|_malloc_r)")
  message(FATAL_ERROR "the program has ${CMAKE_MATCH_1}:\n${symbols}")
endif()

# QEMU emulates the board; semihosting prints the bits of the results.
execute_process(
  COMMAND ${QEMU} -M ${board} -nographic -semihosting-config enable=on,target=native -kernel ${FOLDER}/arm.elf
  OUTPUT_VARIABLE on_board ERROR_VARIABLE on_board RESULT_VARIABLE status TIMEOUT 20)
run(output cc -std=gnu99 -I${FOLDER}/c ${SOURCE_DIR}/cortex.c ${sources} -o ${FOLDER}/here -lm)
run(here ${FOLDER}/here)
string(REGEX MATCHALL "[^\n]+" on_board "${on_board}")
string(REGEX MATCHALL "[^\n]+" here "${here}")
list(LENGTH here count)
list(LENGTH on_board count_on_board)
if(NOT count EQUAL 24 OR NOT count_on_board EQUAL 24)
  message(FATAL_ERROR "the board printed ${count_on_board} lines, this machine ${count}, both should 24: ${on_board}")
endif()
foreach(a b IN ZIP_LISTS on_board here)
  math(EXPR difference "${a} - ${b}")
  # Differences are in units of 1e-5 N m.
  if(difference GREATER 20 OR difference LESS -20)
    message(FATAL_ERROR "the board gives ${a}, this machine ${b}")
  endif()
endforeach()
