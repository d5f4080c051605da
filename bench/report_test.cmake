# Tests the report with benchmarks and an nm that print known results.
#     cmake -DREPORT=<program> -DDIRECTORY=<scratch> -P report_test.cmake
file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY})

function(write_script name text)
  file(WRITE ${DIRECTORY}/${name} "#!/bin/sh\n${text}\n")
  file(CHMOD ${DIRECTORY}/${name} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()

# A benchmark that prints to standard output, as some libraries do, and writes its results to the given file.
function(write_benchmark name results)
  write_script(${name} "echo chat
for argument; do
  case $argument in --benchmark_out=*) file=\${argument#*=};; esac
done
cat > \"$file\" <<'END'
${results}
END")
endfunction()

# Repetitions are not in order; medians count, 21.84 here; the benchmark leaves out a counter of zero.
write_benchmark(leg_bench [=[
{"context": {"host_name": "secret", "robot": "Leg", "joints": "2", "states": "1024", "floating_base": "no",
  "peers": "Judge\nSlow judge", "absent": "Stranger: not installed\nOther: has no legs", "num_cpus": 2,
  "compared/inverse_dynamics": "inverse_dynamics"},
 "benchmarks": [
 {"run_name": "strange", "family_index": 1, "run_type": "iteration", "cpu_time": 5, "label": "strange"},
 {"run_name": "inverse_dynamics", "family_index": 0, "run_type": "iteration", "cpu_time": 99.9,
  "label": "inverse_dynamics", "mul": 3.3e1, "add": 24, "sincos": 2, "instructions": 36, "critical_path": 44},
 {"run_name": "inverse_dynamics", "family_index": 0, "run_type": "iteration", "cpu_time": 21.5},
 {"run_name": "Judge/inverse_dynamics", "family_index": 2, "run_type": "iteration", "cpu_time": 109.2},
 {"run_name": "inverse_dynamics", "family_index": 0, "run_type": "iteration", "cpu_time": 21.84},
 {"run_name": "inverse_dynamics", "family_index": 0, "run_type": "aggregate", "cpu_time": 47.7},
 {"run_name": "Leg/inverse_dynamics/given_trig", "family_index": 4, "run_type": "iteration", "cpu_time": 33},
 {"run_name": "inverse_dynamics/batch", "family_index": 5, "run_type": "iteration", "cpu_time": 512, "items_per_second": 2e8},
 {"run_name": "of_nothing/batch", "family_index": 6, "run_type": "iteration", "cpu_time": 7},
 {"run_name": "clock/1024", "family_index": 7, "run_type": "iteration", "cpu_time": 512},
 {"run_name": "Slow judge/inverse_dynamics", "family_index": 3, "run_type": "iteration", "cpu_time": 1000}]}]=])
# A benchmark that is twice as slow, with Judge 20 times as slow as that: Judge's geometric mean is 10.
write_benchmark(arm_bench [=[
{"context": {"robot": "Arm", "joints": "12", "states": "1024", "floating_base": "yes", "peers": "Judge",
  "absent": "Stranger: not installed", "compared/inverse_dynamics": "inverse_dynamics_fully_actuated"},
 "benchmarks": [
 {"run_name": "inverse_dynamics_fully_actuated", "family_index": 0, "run_type": "iteration", "cpu_time": 43.68},
 {"run_name": "Judge/inverse_dynamics", "family_index": 1, "run_type": "iteration", "cpu_time": 873.6}]}]=])
# 0x24c = 588 bytes include a copy of the core. The strange kernel calls its core, which chooses and has two parts:
# 0x10 + 0x20 + 0x100 + 0x40 + 0x40 = 432. The kernel for float, and kernels whose names only begin in the same way, do not
# count.
write_script(nm "cat <<'END'

leg.cpp.o:
0000000000000000 0000000000000fff W void leg::kernel::inverse_dynamics<float>(float const*, float*)
0000000000000000 0000000000000200 W void leg::kernel::core::inverse_dynamics<double>(double const*, double*)
0000000000000000 000000000000024c W void leg::kernel::inverse_dynamics<double>(double const*, double*)
0000000000000000 0000000000000075 W void leg::batch::kernel::inverse_dynamics<double>(long, double const*)
0000000000000000 0000000000000010 W void leg::kernel::strange<double>(double const*, double*)
0000000000000000 0000000000000020 W void leg::kernel::core::strange<double>(double const*, double*)
0000000000000000 0000000000000100 t void leg::kernel::core::in_lanes::strange<double>(double const*, double*)
0000000000000000 0000000000000040 t void leg::kernel::core::in_lanes::parts::strange_1<double>(double const*, double*)
0000000000000000 0000000000000040 t void leg::kernel::core::in_lanes::parts::strange_2<double>(double const*, double*)
0000000000000000 0000000000000300 t void leg::kernel::core::in_lanes::parts::strange_thing_1<double>(double const*)
0000000000000000 0000000000000111 W void leg::kernel::inverse_dynamics_gravity<double>(double const*, double*)
                 U sin
END")
write_benchmark(broken_bench "no JSON")
write_script(disagreeing_bench "echo 'Judge disagrees' >&2; exit 1")

# Two sources of the leg, which the compiler compiles, and one source of its batches and one of another library, which
# nothing compiles.
write_script(compiler "[ \"$1 $3\" = '-o -c' ] && [ $4 != broken.cpp ] && echo object > \"$2\"")
foreach(source leg/CMakeFiles/leg.dir/a leg/CMakeFiles/leg.dir/b leg/CMakeFiles/leg.dir/batch/broken
               leg/CMakeFiles/leg_test.dir/c CMakeFiles/broken.dir/broken)
  cmake_path(GET source FILENAME name)
  list(APPEND entries "{\"directory\": \"${DIRECTORY}\", \"command\": \"./compiler -o ${source}.o -c ${name}.cpp\"}")
endforeach()
list(JOIN entries "," entries)
file(WRITE ${DIRECTORY}/commands.json "[${entries}]")

set(files --json ${DIRECTORY}/report.json --chart ${DIRECTORY}/chart.svg --markdown ${DIRECTORY}/report.md)
execute_process(
  COMMAND ${REPORT} --nm ${DIRECTORY}/nm --compile-commands ${DIRECTORY}/commands.json ${files} --compiler "Judge's C++ 12" --flags -O7 ${DIRECTORY}/leg_bench=libleg.a
          ${DIRECTORY}/arm_bench=libarm.a
  OUTPUT_VARIABLE table
  RESULT_VARIABLE status)
foreach(row
    "Leg, 2 degrees of freedom; compiled in [0-9.]+ s; 2.00 GHz"
    " +inverse_dynamics +21.8 +33.0 +5.0 +33 +24 +0 +0 +2 +36 +44 +44 +66 +1.50 +588"
    " +strange +5.0 +- +- +- +- +- +- +- +- +- +- +- +- +432"
    " +of_nothing/batch +7.0 +- +- +- +- +- +- +- +- +- +- +- +- +-"
    "Arm, 18 degrees of freedom"
    "robot, DoF +quantity +RobCoGen +Judge +Slow judge"
    "Leg, 2 +inverse dynamics +21.8 +109.2 +5.0x +1000.0 +45.8x"
    "Arm, 18 +inverse dynamics +43.7 +873.6 +20.0x +-"
    "geometric mean +inverse dynamics +.robots. +.2. +10.0x +.1. +45.8x"
    "not measured: Stranger: not installed"
    "not measured: Other: has no legs .Leg."
    "written: ${DIRECTORY}/report.json")
  if(NOT status EQUAL 0 OR NOT table MATCHES "\n${row}\n")
    message(FATAL_ERROR "status ${status}, no row '${row}' in\n${table}")
  endif()
endforeach()

file(READ ${DIRECTORY}/report.json json)
function(expect_json value)
  string(JSON found GET "${json}" ${ARGN})
  if(NOT found EQUAL value AND NOT found STREQUAL value)
    message(FATAL_ERROR "${ARGN} is '${found}' and not '${value}' in\n${json}")
  endif()
endfunction()
expect_json("Judge's C++ 12" compiler)
expect_json(-O7 flags)
expect_json(2 machine processors)
expect_json(1024 method states)
expect_json(2 robots 0 gigahertz)
expect_json(33 robots 0 functions 0 given_trig median)
expect_json(5 robots 0 functions 0 batch median)
expect_json(44 robots 0 functions 0 bound_cycles)
expect_json(66 robots 0 functions 0 cycles_given_trig)
string(JSON seconds GET "${json}" robots 0 compile_time)
string(JSON none ERROR_VARIABLE absent GET "${json}" robots 1 compile_time)
if(absent STREQUAL NOTFOUND OR EXISTS ${DIRECTORY}/leg_bench.o)
  message(FATAL_ERROR "no sources took ${none} s, or an object is left behind")
endif()
expect_json(588 robots 0 functions 0 bytes)
expect_json(36 robots 0 functions 0 counts instructions)
expect_json(21.84 robots 0 comparisons 0 time median)
expect_json(21.5 robots 0 comparisons 0 time min)
expect_json(99.9 robots 0 comparisons 0 time max)
expect_json(5 robots 0 comparisons 0 peers 0 ratio)
expect_json("has no legs" robots 0 absent 1 reason)
expect_json(ON robots 1 floating_base)
expect_json(inverse_dynamics_fully_actuated robots 1 comparisons 0 function)
expect_json(Judge geometric_means 0 peer)
expect_json(2 geometric_means 0 robots)
if(json MATCHES "secret|host|date|${DIRECTORY}")
  message(FATAL_ERROR "the report says where it was made:\n${json}")
endif()
file(READ ${DIRECTORY}/report.md page)
foreach(row
    "Leg, 2 | inverse dynamics | 21.8 | 33.0 | 5.0 | 33 / 24 / 0 | 36 | 44 | 44 | 1.50 | 588 | "
    "Arm, 6 + 12 | inverse dynamics | 43.7 | - | - | 0 / 0 / 0 | 0 | 0 | - | - | - | - |\n"
    "Arm, 6 + 12 | inverse dynamics | 43.7 | 20.0 | - |\n")
  string(FIND "${page}" "\n| ${row}" at)
  if(at LESS 0)
    message(FATAL_ERROR "no row '${row}' in\n${page}")
  endif()
endforeach()
file(READ ${DIRECTORY}/chart.svg chart)
if(NOT chart MATCHES "Judge, Arm: 873.6 ns")
  message(FATAL_ERROR "a point is missing in\n${chart}")
endif()

# If a program fails or its results cannot be read, the rest is measured, but no file is written.
foreach(argument ${DIRECTORY}/broken_bench=libleg.a ${DIRECTORY}/disagreeing_bench=libleg.a ${DIRECTORY}/absent=libleg.a
                 no_library)
  file(REMOVE ${DIRECTORY}/report.json)
  execute_process(
    COMMAND ${REPORT} ${files} ${argument} ${DIRECTORY}/arm_bench=libarm.a
    OUTPUT_QUIET ERROR_VARIABLE errors RESULT_VARIABLE status)
  if(status EQUAL 0 OR errors STREQUAL "" OR EXISTS ${DIRECTORY}/report.json)
    message(FATAL_ERROR "${argument} was accepted")
  endif()
endforeach()
execute_process(
  COMMAND ${REPORT} --json ${DIRECTORY}/no/folder/report.json ${DIRECTORY}/arm_bench=libarm.a
  OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 2)
  message(FATAL_ERROR "a file that cannot be written: status ${status}")
endif()
