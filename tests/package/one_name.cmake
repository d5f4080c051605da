# Two models of one name in a program: the linker refuses them, in C++ and in C, because the program would call the
# functions of one of them for both. One model twice, and two namespaces, are fine.
#
# cmake -D TOOL=robcogen -D WORK_DIR=dir -D CXX_COMPILER=c++ -D SOURCE_DIR=robcogen -D EIGEN_DIR=dir -P one_name.cmake
cmake_minimum_required(VERSION 3.22...3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(work_dir ${WORK_DIR}/one_name)
file(REMOVE_RECURSE ${work_dir})
set(compile ${CXX_COMPILER} -std=c++17 -O0 -DROBCOGEN_REFERS_TO_MODEL -I ${SOURCE_DIR}/runtime/include -isystem ${EIGEN_DIR} -c)

# add_library(LIBRARY MASS option…): a lever of this mass, whose sources say how much it weighs.
function(add_library_of library mass)
  set(dir ${work_dir}/${library})
  file(
    WRITE ${dir}/arm.urdf
    "<robot name='arm'><link name='base'/><link name='lever'><inertial><origin xyz='0.3 0 0'/><mass value='${mass}'/>\
<inertia ixx='0.01' iyy='0.02' izz='0.02' ixy='0' ixz='0' iyz='0'/></inertial></link>\
<joint name='hinge' type='continuous'><parent link='base'/><child link='lever'/><axis xyz='0 1 0'/></joint></robot>")
  run(output ${TOOL} generate ${dir}/arm.urdf -o ${dir} --algorithms inverse_dynamics --language cpp c ${ARGN})
  string(REGEX MATCH "left" enclosing "${ARGN}")
  set(header arm/arm.h)
  set(space arm)
  set(c arm)
  if(enclosing)
    set(header left/arm/arm.h)
    set(space left::arm)
    set(c left_arm)
  endif()
  file(WRITE ${dir}/use.cpp "#include <${header}>\n#include <${c}_c/${c}_c.h>\n
double weight_${library}() { return ${space}::inverse_dynamics(${space}::JointState::Zero(), ${space}::JointState::Zero(), ${space}::JointState::Zero())[0]; }\n")
  file(WRITE ${dir}/use_c.cpp "#include <${c}_c/${c}_c.h>\n
double weight_in_c_${library}() { double q = 0, tau; ${c}_inverse_dynamics(&q, &q, &q, &tau); return tau; }\n")
  file(GLOB_RECURSE cpp ${dir}/arm/*.cpp ${dir}/left/arm/*.cpp)
  file(GLOB in_c ${dir}/c/${c}_c/*.c)
  list(FILTER in_c EXCLUDE REGEX "casadi|_f[.]c")
  foreach(source ${dir}/use.cpp ${dir}/use_c.cpp ${cpp} ${in_c})
    cmake_path(GET source STEM name)
    set(language "")
    if(source MATCHES "[.]c$")
      set(language -x c -std=c99)
      set(name c_${name})
    endif()
    string(REPLACE "-std=c++17" "" flags "${compile}")
    if(NOT language)
      set(flags ${compile})
    endif()
    run(output ${flags} -I ${dir} -I ${dir}/c ${language} ${source} -o ${dir}/${name}.o)
  endforeach()
  file(GLOB objects ${dir}/*.o)
  list(FILTER objects EXCLUDE REGEX "/use(_c)?[.]o$")
  run(output ar rcs ${dir}/library.a ${objects})
endfunction()

add_library_of(light 1)
add_library_of(heavy 2)
add_library_of(other 2 --namespace left)

# Links a program that uses both; `suffix` selects C++ or C.
macro(set_program first second suffix name)
  file(WRITE ${work_dir}/main.cpp "#include <cstdio>\ndouble ${name}_${first}(), ${name}_${second}();\n
int main() { std::printf(\"%.3f %.3f\", ${name}_${first}(), ${name}_${second}()); }\n")
  run(output ${CXX_COMPILER} -c ${work_dir}/main.cpp -o ${work_dir}/main.o)
  set(program
      ${CXX_COMPILER} ${work_dir}/main.o ${work_dir}/${first}/use${suffix}.o ${work_dir}/${second}/use${suffix}.o
      ${work_dir}/${first}/library.a ${work_dir}/${second}/library.a -lm -o ${work_dir}/main)
endmacro()

foreach(case ";weight" "_c;weight_in_c")
  list(POP_FRONT case suffix name)
  set_program(light heavy "${suffix}" ${name})
  run_failing(output ${program})
  expect_words("two models" "${output}" "two_models_have_the_same_NAME_and_NAMESPACE")
  set_program(light other "${suffix}" ${name})
  run(output ${program})
  run(output ${work_dir}/main)
  expect_equal("weights" "${output}" "-2.943 -5.886")
endforeach()
