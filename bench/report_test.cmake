# The report, of a benchmark and an nm that print what is known beforehand.
#     cmake -DREPORT=<program> -DDIRECTORY=<scratch> -P report_test.cmake
file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY})

function(write_program name text)
  file(WRITE ${DIRECTORY}/${name} "#!/bin/sh\ncat <<'END'\n${text}\nEND\n")
  file(CHMOD ${DIRECTORY}/${name} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()

# Only medians count; a counter of zero is left out by the benchmark.
write_program(leg_bench [=[
{"context": {"robot": "Leg"}, "benchmarks": [
 {"run_name": "inverse_dynamics", "aggregate_name": "mean", "cpu_time": 77.7, "label": "inverse_dynamics", "mul": 33},
 {"run_name": "inverse_dynamics", "aggregate_name": "median", "cpu_time": 21.84, "label": "inverse_dynamics",
  "mul": 3.3e1, "add": 24, "sincos": 2, "instructions": 36, "critical_path": 44},
 {"run_name": "strange", "aggregate_name": "median", "cpu_time": 5, "label": "strange"}]}]=])
# 0x24c = 588 bytes; the kernel for float, and one whose name only begins alike, are others.
write_program(nm [=[

leg.cpp.o:
0000000000000000 0000000000000fff W void leg::kernel::inverse_dynamics<float>(float const*, float*)
0000000000000000 000000000000024c W void leg::kernel::inverse_dynamics<double>(double const*, double*)
0000000000000000 0000000000000111 W void leg::kernel::inverse_dynamics_gravity<double>(double const*, double*)
                 U sin]=])
write_program(broken_bench "no JSON")

execute_process(
  COMMAND ${REPORT} --nm ${DIRECTORY}/nm ${DIRECTORY}/leg_bench=libleg.a OUTPUT_VARIABLE table RESULT_VARIABLE status)
foreach(row "Leg +inverse_dynamics +21.8 +33 +24 +0 +2 +36 +44 +588" "Leg +strange +5.0 +- +- +- +- +- +- +-")
  if(NOT status EQUAL 0 OR NOT table MATCHES "\n${row}\n")
    message(FATAL_ERROR "status ${status}, no row '${row}' in\n${table}")
  endif()
endforeach()

foreach(argument ${DIRECTORY}/broken_bench=libleg.a ${DIRECTORY}/absent=libleg.a no_library)
  execute_process(
    COMMAND ${REPORT} ${argument} OUTPUT_QUIET ERROR_VARIABLE errors RESULT_VARIABLE status)
  if(status EQUAL 0 OR errors STREQUAL "")
    message(FATAL_ERROR "${argument} was accepted")
  endif()
endforeach()
