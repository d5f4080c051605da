# robcogen_add_robot: makes a static library from a robot document, a URDF, an SDF or an MJCF model.
#
#     robcogen_add_robot(
#       TARGET hyl                  # the library; alias ${PROJECT_NAME}::hyl
#       MODEL hyl.kindsl            # the robot, .kindsl, .urdf, .sdf, .xml (URDF or MJCF) or .urdf.xacro, relative to the calling
#                                   # CMakeLists.txt
#       [IMPORT_DIRS folder…]       # folders to search for documents that MODEL imports, models that an SDF includes, and
#                                   # packages with meshes of a URDF
#       [XACRO_ARGS name:=value…]   # for a .urdf.xacro, which the build expands with the program `xacro`, or with the one
#                                   # that the variable ROBCOGEN_XACRO names; included files are dependencies
#       [FLOATING_BASE]             # URDF: the root link floats (a robot document states it)
#       [SNAP_ANGLES]               # URDF, SDF: angles within 1e-6 of a multiple of PI/12 become that multiple
#       [PASSIVE_FORCES]            # URDF: damping and friction of joints are part of the dynamics
#       [LOCK joint = position…]    # joints that do not move, by name or pattern, which are removed from the robot; parameters
#                                   # with a constant value
#       [KEEP joint|pattern…]       # the only joints that remain; all others are locked, at zero or where LOCK puts them
#       [PARAMETERS element.quantity…]
#                                   # quantities that become parameters, such as tool0.inertia, *.mass, joint2.rotor; their
#                                   # values in the document are the defaults
#       [ROBOT name]                # the robot among several in MODEL: in MJCF its first body, in SDF its model
#       [SRDF arm.srdf]             # URDF: pairs of links that functions of the group `collision` do not check
#       [FRICTION_VELOCITY number]  # URDF, with PASSIVE_FORCES: friction is smooth, friction qd / sqrt(qd^2 + number^2)
#       [DESIRED hyl.dtdsl]         # the transforms and Jacobians to generate; without it and FRAMES, those of the frames at
#                                   # which limbs end
#       [NAME ident]                # folder and namespace of the generated code; without it, TARGET as an identifier
#       [NAMESPACE a::b]            # enclosing namespace, and folder: <a/b/NAME/NAME.h>. Targets may have the
#                                   # same NAME when their NAMESPACEs differ
#       [ALGORITHMS group…]         # groups of functions, from the list in this file, or `all`; without it, the default
#                                   # ones. README.md describes them
#       [DERIVATIVES function:input…]
#                                   # partial derivatives of any functions by any of their inputs, as further functions:
#                                   # inverse_dynamics:q,qd makes inverse_dynamics_d_q_qd
#       [GRADIENTS function:input…] # gradients of a weighted sum of a function's results, by reverse mode:
#                                   # inverse_dynamics:q,qd makes inverse_dynamics_gradient_q_qd, which takes weights
#       [TANGENTS function:input…]  # rates of a function's results at given rates of inputs, by forward mode:
#                                   # inverse_dynamics:q,qd makes inverse_dynamics_tangent_q_qd, which takes q_tangent and
#                                   # qd_tangent. The functions of all three may be among each other's. `all`, in any of
#                                   # them: every function that none of them names, by its arguments
#       [FRAMES frame|pattern…]     # functions of frames (transforms, Jacobians, world, …) for these frames only, such as
#                                   # *_foot: to and from the base, and a Jacobian of each; with DESIRED, those of its pairs.
#                                   # FRAMES * for all
#       [FUNCTIONS name = function + function…  name = …]
#                                   # further functions, each with the results of several in one call
#       [CONTACTS frame[:point|:surface]…]
#                                   # frames in contact with a fixed environment, for functions of contacts: three rows for
#                                   # a point, six for a surface. Without ALGORITHMS, the default groups and `contacts`
#       [INVERSE_KINEMATICS left:right[:point|:axis|:swivel|:given=joint][:tolerance=number]…]
#                                   # joint positions for the pose of frame right in frame left, in closed form; for the
#                                   # position of its origin, for that and its z axis, or with one joint or the
#                                   # swivel angle given. With a tolerance (1e-3), axes may be off those of a chain with
#                                   # a closed form. Without ALGORITHMS, the default groups and `inverse_kinematics`
#       [BATCH]                     # each function also over many states at once, <hyl/batch.h>: compiling takes about
#                                   # three times as long. On x86-64 (gcc, clang) for AVX-512 and for AVX2; a program
#                                   # selects one level when it starts
#       [BATCH_LEVELS level…]       # levels that BATCH compiles for, from baseline, avx2 and avx512; without it, avx2 and
#                                   # avx512. A program uses the best level of its machine, and computes one state after
#                                   # the other if there is none. Without avx2, the baseline is included
#       [PROCESSORS level…]         # levels that the functions of one state are compiled for, from baseline, avx2 and avx512;
#                                   # a program chooses when it starts. The baseline is always included. README.md describes
#                                   # the default and builds whose options choose a processor (-march=…, -mavx2, …)
#       [SINGLE_PRECISION]          # all functions also in float, in the namespace hyl::f32: twice as much to compile
#       [DOUBLE_ONLY]               # the default: nothing in float
#       [LANGUAGES cpp c gpu matlab maxima javascript]
#                                   # without it, cpp. Text in the others goes to OUTPUT_DIR/<language>. The C code becomes
#                                   # the library <TARGET>_c (RobcogenC.cmake), the text for GPUs <TARGET>_gpu and
#                                   # <TARGET>_cuda (RobcogenGpu.cmake); the rest is not compiled
#       [GPU_ARCHITECTURES number…] # of <TARGET>_cuda, as in CUDA_ARCHITECTURES of CMake, which is the default
#       [PYTHON]                    # also a Python module (RobcogenPython.cmake)
#       [JAX] [TORCH]               # with PYTHON, GRADIENTS all: JAX and PyTorch differentiate the module's functions
#       [CASADI]                    # also the library <TARGET>_casadi of external functions of CasADi (RobcogenC.cmake)
#       [COMPATIBILITY robcogen]    # also the headers of the first RobCoGen, for programs that were written for it, in the
#                                   # namespace NAMESPACE (without it, iit::<robot>) and the folder INCLUDE_PATH
#       [INCLUDE_PATH folder]       # without it, iit/robots/<NAME in small letters>
#       [COMPATIBILITY_RUNTIME own] # for programs without <iit/rbd/…>: that of this project
#       [VAMP frame]                # also the header <vamp/robots/NAME.hh>, NAME in small letters, for the motion planner
#                                   # VAMP, with the end effector in this frame. Adds the groups `collision` and `transforms`
#       [DEPENDS file|target…]      # if a rule of the build generates MODEL or DESIRED
#       [COMPILE_OPTIONS option…]   # for the generated translation units only. Without an -O here, they get -O2 in
#                                   # configurations without optimisation, such as Debug or none
#       [OUTPUT_DIR dir]            # include root; without it, ${CMAKE_CURRENT_BINARY_DIR}/robcogen.gen/<TARGET>
#       [NO_TESTS] [NO_BENCH] [TEST_SEED n] [TEST_SAMPLES n]
#       [TEST_STACK_LIMIT bytes]    # for the stack frames of a kernel, its core and a part together; without it, 65536: half
#                                   # of the smallest default stack of a thread (musl). With BATCH, 262144, including the
#                                   # frame of the kernel's caller: eight states at once need eight times the memory
#       [EXCLUDE_FROM_ALL]
#       [EXPORT_FILES variable]     # receives the absolute paths of the generated files
#       [OPTIONS flag…])            # further flags of `robcogen generate`, such as --free-mimic-joints (URDF)
#
# Defines, for TARGET hyl in C++ (for other languages only, a target hyl that generates them):
#     hyl            the static library; #include <hyl/hyl.h>
#     hyl_codegen    the generated files only
#     hyl_selfcheck  compares the compiled code with an independent recursion, and functions over many states with
#                    those of one state; ctest hyl.selfcheck, label `robot` (if BUILD_TESTING is on)
#     hyl_allocations  runs every function with an allocator that aborts; ctest hyl.allocations. The ctest
#                    hyl.real_time checks the compiled files (RobcogenRealTime.cmake)
#     hyl_bench      times the functions (if Google Benchmark is found)
#     hyl_view       writes OUTPUT_DIR/hyl.html, a page that shows the robot and moves it; not part of `all`
# and the umbrellas robcogen_codegen and robcogen_bench. An error in the call stops the configuration.
#
# The list of generated files follows from the keywords only: the configuration neither reads a model nor runs the tool.
cmake_minimum_required(VERSION 3.22...3.25)
include_guard(GLOBAL)

include(${CMAKE_CURRENT_LIST_DIR}/RobcogenArguments.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenC.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenCompatibility.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenGpu.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenInstall.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenProcessors.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenPython.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenRos.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenTool.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenUnity.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenView.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/RobcogenXacro.cmake)

set_property(GLOBAL PROPERTY ROBCOGEN_VERSION ${robcogen_VERSION})
# ROBCOGEN_GROUPS and ROBCOGEN_DEFAULT_GROUPS: the groups of functions, from the generator's list. In an installed package it
# is in the folder of this file.
function(_robcogen_read_groups)
  set(file ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/groups.inc)
  if(NOT EXISTS ${file})
    set(file ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../tool/algorithm/catalogue/groups.inc)
  endif()
  if(NOT CMAKE_SCRIPT_MODE_FILE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endif()
  file(STRINGS ${file} lines REGEX "^ROBCOGEN_GROUP\\(")
  foreach(line IN LISTS lines)
    if(line MATCHES "^ROBCOGEN_GROUP\\(([a-z_]+), (true|false),")
      list(APPEND groups ${CMAKE_MATCH_1})
      if(CMAKE_MATCH_2)
        list(APPEND default_groups ${CMAKE_MATCH_1})
      endif()
    endif()
  endforeach()
  set_property(GLOBAL PROPERTY ROBCOGEN_GROUPS ${groups})
  set_property(GLOBAL PROPERTY ROBCOGEN_DEFAULT_GROUPS ${default_groups})
endfunction()
_robcogen_read_groups()

function(robcogen_add_robot)
  set(flags FLOATING_BASE SNAP_ANGLES PASSIVE_FORCES BATCH SINGLE_PRECISION DOUBLE_ONLY PYTHON JAX TORCH CASADI NO_TESTS NO_BENCH EXCLUDE_FROM_ALL)
  set(values TARGET MODEL ROBOT SRDF DESIRED NAME NAMESPACE OUTPUT_DIR FRICTION_VELOCITY TEST_SEED TEST_SAMPLES TEST_STACK_LIMIT EXPORT_FILES COMPATIBILITY INCLUDE_PATH COMPATIBILITY_RUNTIME VAMP)
  set(lists IMPORT_DIRS XACRO_ARGS LOCK KEEP PARAMETERS ALGORITHMS DERIVATIVES GRADIENTS TANGENTS FUNCTIONS FRAMES CONTACTS INVERSE_KINEMATICS BATCH_LEVELS PROCESSORS LANGUAGES GPU_ARCHITECTURES DEPENDS COMPILE_OPTIONS OPTIONS)
  cmake_parse_arguments(PARSE_ARGV 0 library "${flags}" "${values}" "${lists}")
  get_property(groups GLOBAL PROPERTY ROBCOGEN_GROUPS)

  set(library_CALL robcogen_add_robot)
  _robcogen_refuse_repeated("${values}" ${ARGV})
  _robcogen_check_keywords(${values} ${lists} ${flags})
  if("${library_MODEL}" STREQUAL "")
    _robcogen_refuse("MODEL is missing")
  endif()
  _robcogen_complete_arguments()
  _robcogen_check_elements(ALGORITHMS ${groups} all)
  _robcogen_choose_gradients()
  _robcogen_choose_groups()
  _robcogen_check_derivatives()
  _robcogen_check_functions()
  _robcogen_check_elements(LANGUAGES cpp c gpu matlab maxima javascript)
  _robcogen_check_compatibility()
  _robcogen_check_cpp()
  _robcogen_check_c()
  _robcogen_check_gpu()
  _robcogen_check_python()
  _robcogen_check_elements(BATCH_LEVELS baseline avx2 avx512)
  if(library_BATCH_LEVELS AND NOT library_BATCH)
    _robcogen_refuse("BATCH_LEVELS needs BATCH")
  endif()
  _robcogen_check_elements(PROCESSORS baseline avx2 avx512)
  _robcogen_choose_levels()
  _robcogen_check_documents(MODEL)
  _robcogen_check_robot()
  _robcogen_check_names()
  _robcogen_require_tool()

  _robcogen_is_xacro("${library_MODEL}" is_xacro)
  if(is_xacro)
    _robcogen_expand_xacro()
  endif()
  _robcogen_check_cpp_compiler()
  _robcogen_choose_c_checks()
  _robcogen_c_files("${library_groups}")
  _robcogen_gpu_files("${library_groups}")
  _robcogen_python_files()
  # Not those of the caller, whose variables a function sees.
  set(headers "")
  set(sources "")
  if(NOT "cpp" IN_LIST library_LANGUAGES)
    _robcogen_add_text()
    _robcogen_add_c_checks()
    _robcogen_add_view(${library_TARGET}_view)
    return()
  endif()
  _robcogen_folder(folder)
  _robcogen_generated_files(${folder} "${library_groups}" headers sources)
  _robcogen_level_files(${folder} level_sources)
  list(APPEND sources ${level_sources})
  if(library_BATCH)
    _robcogen_batch_files(${folder} "${library_groups}" batch_headers batch_sources)
    list(APPEND headers ${batch_headers})
    list(APPEND sources ${batch_sources})
  endif()
  _robcogen_compatibility_files(${folder} compatibility_headers)
  list(APPEND headers ${compatibility_headers})
  if(NOT "${library_VAMP}" STREQUAL "")
    string(TOLOWER "vamp/robots/${library_NAME}.hh" vamp_header)
    list(APPEND headers ${vamp_header})
  endif()
  list(TRANSFORM headers PREPEND ${library_OUTPUT_DIR}/)
  list(TRANSFORM sources PREPEND ${library_OUTPUT_DIR}/)
  _robcogen_add_codegen(${library_TARGET}_codegen)
  _robcogen_add_view(${library_TARGET}_view)
  set(generated_sources ${sources})
  if(library_BATCH)
    _robcogen_omit_levels()
  endif()
  _robcogen_unite_sources(${library_OUTPUT_DIR}/${folder})
  _robcogen_add_library(${library_TARGET})
  _robcogen_link_compatibility()
  _robcogen_add_c_library()
  _robcogen_add_gpu_libraries()
  _robcogen_add_python()
  _robcogen_set_levels(${library_TARGET})
  if(BUILD_TESTING AND NOT library_NO_TESTS)
    _robcogen_add_selfcheck(${library_TARGET}_selfcheck)
    _robcogen_add_allocations(${library_TARGET}_allocations)
    _robcogen_add_real_time_check(robot ${library_TARGET})
  endif()
  _robcogen_add_c_checks()
  if(NOT library_NO_BENCH)
    _robcogen_add_bench(${library_TARGET}_bench)
  endif()
  if(NOT "${library_EXPORT_FILES}" STREQUAL "")
    set(${library_EXPORT_FILES} ${headers} ${generated_sources} ${c_headers} ${c_sources} ${c_casadi} ${gpu_headers} ${gpu_sources} ${python_files} PARENT_SCOPE)
  endif()
endfunction()

# Checks the file type of MODEL, and keywords that need a certain type.
function(_robcogen_check_robot)
  cmake_path(GET library_MODEL EXTENSION LAST_ONLY extension)
  if(NOT extension MATCHES "^\\.(kindsl|urdf|sdf|world|xml|xacro)$")
    _robcogen_refuse(
      "MODEL must be a .kindsl document, a .urdf, an .sdf, an .xml (URDF or MJCF) or a .urdf.xacro, not '${extension}': ${library_MODEL}")
  endif()
  if(NOT "${library_XACRO_ARGS}" STREQUAL "" AND NOT extension STREQUAL ".xacro")
    _robcogen_refuse("XACRO_ARGS is for a MODEL that xacro expands, with the extension .urdf.xacro or .xacro: ${library_MODEL}")
  endif()
  if(NOT "${library_FRICTION_VELOCITY}" STREQUAL "")
    if(NOT library_PASSIVE_FORCES)
      _robcogen_refuse("FRICTION_VELOCITY needs PASSIVE_FORCES: without them, friction is not part of the dynamics")
    endif()
    if(NOT "${library_FRICTION_VELOCITY}" MATCHES "^[0-9]*[.]?[0-9]+(e-?[0-9]+)?$" OR "${library_FRICTION_VELOCITY}" MATCHES "^[0.]+(e.*)?$")
      _robcogen_refuse("FRICTION_VELOCITY is a positive number (rad/s, m/s), not '${library_FRICTION_VELOCITY}'")
    endif()
  endif()
  foreach(keyword FLOATING_BASE SNAP_ANGLES PASSIVE_FORCES)
    if(library_${keyword} AND extension STREQUAL ".kindsl")
      _robcogen_refuse("${keyword} is for URDF; a robot document states this itself: ${library_MODEL}")
    endif()
  endforeach()
  if(library_ROBOT AND NOT extension MATCHES "^\\.(xml|sdf|world)$")
    _robcogen_refuse("ROBOT is for MJCF and SDF, whose scenes have several robots: ${library_MODEL}")
  endif()
endfunction()

# Sets `result` to the path of a robot's header. If the robot has the name of a header, <name>/<name>.h is the umbrella
# header, and the other header becomes <stem>_.h.
function(_robcogen_header folder stem result)
  cmake_path(GET folder FILENAME name)
  string(TOLOWER ${name} lower)
  if(lower STREQUAL stem)
    string(APPEND stem _)
  endif()
  set(${result} ${folder}/${stem}.h PARENT_SCOPE)
endfunction()

# Sets `result` to the folder of a library's files: its name, below one folder for each enclosing namespace.
function(_robcogen_folder result)
  string(REPLACE "::" ";" parts "${library_NAMESPACE}")
  list(APPEND parts ${library_NAME})
  list(JOIN parts "/" folder)
  set(${result} ${folder} PARENT_SCOPE)
endfunction()

# Sets library_groups to the groups of functions that ALGORITHMS selects.
function(_robcogen_choose_groups)
  set(chosen ${library_ALGORITHMS})
  if(NOT chosen)
    get_property(chosen GLOBAL PROPERTY ROBCOGEN_DEFAULT_GROUPS)
    if(NOT "${library_CONTACTS}" STREQUAL "")
      list(APPEND chosen contacts)
    endif()
    if(NOT "${library_INVERSE_KINEMATICS}" STREQUAL "")
      list(APPEND chosen inverse_kinematics)
    endif()
  elseif("all" IN_LIST chosen)
    # Collision shapes are not among all: they are read where their group is named.
    get_property(groups GLOBAL PROPERTY ROBCOGEN_GROUPS)
    set(named all)
    if("collision" IN_LIST chosen)
      list(APPEND named collision)
    else()
      list(REMOVE_ITEM groups collision)
    endif()
    set(chosen ${groups})
    set(library_ALGORITHMS ${named} PARENT_SCOPE)
  endif()
  if(library_FUNCTIONS AND NOT "fused" IN_LIST chosen)
    list(APPEND chosen fused)
  endif()
  if(library_COMPATIBILITY)
    _robcogen_compatibility_groups(compatibility_groups)
    list(APPEND chosen ${compatibility_groups})
    list(REMOVE_DUPLICATES chosen)
  endif()
  if(NOT "${library_VAMP}" STREQUAL "")
    list(APPEND chosen collision transforms)
    list(REMOVE_DUPLICATES chosen)
  endif()
  if(library_DERIVATIVES OR library_GRADIENTS OR library_TANGENTS)
    list(APPEND chosen derivatives)
  endif()
  set(library_groups ${chosen} PARENT_SCOPE)
endfunction()

# Sets `headers` and `sources` to the files of a robot with these groups in its folder, relative to its include root.
function(_robcogen_generated_files folder chosen headers sources)
  get_property(groups GLOBAL PROPERTY ROBCOGEN_GROUPS)
  cmake_path(GET folder FILENAME name)
  set(header_list ${folder}/${name}.h)
  foreach(stem model types parameters reflection)
    _robcogen_header(${folder} ${stem} header)
    list(APPEND header_list ${header})
  endforeach()
  list(APPEND header_list ${folder}/detail/kernels.h ${folder}/detail/functions.inc ${folder}/kernel/parameters.h
       ${folder}/kernel/trigonometry.h)
  set(source_list ${folder}/parameters.cpp ${folder}/trigonometry.cpp)
  foreach(group IN LISTS groups ITEMS derivatives)
    if(group IN_LIST chosen)
      list(APPEND header_list ${folder}/kernel/${group}.h)
      list(APPEND source_list ${folder}/${group}.cpp)
    endif()
  endforeach()
  if("collision" IN_LIST chosen)
    _robcogen_header(${folder} collision_check header)
    list(APPEND header_list ${header})
  endif()
  set(${headers} ${header_list} PARENT_SCOPE)
  set(${sources} ${source_list} PARENT_SCOPE)
endfunction()

# The same for the files that BATCH adds.
function(_robcogen_batch_files folder chosen headers sources)
  get_property(groups GLOBAL PROPERTY ROBCOGEN_GROUPS)
  _robcogen_header(${folder} batch header)
  set(header_list ${header})
  set(source_list ${folder}/batch.cpp)
  foreach(group IN LISTS groups ITEMS derivatives)
    if(group IN_LIST chosen)
      list(APPEND header_list ${folder}/batch/${group}.h)
      foreach(level baseline avx2 avx512)
        list(APPEND source_list ${folder}/batch/${group}_${level}.cpp)
      endforeach()
    endif()
  endforeach()
  set(${headers} ${header_list} PARENT_SCOPE)
  set(${sources} ${source_list} PARENT_SCOPE)
endfunction()

# The output of the rule is a stamp, and the files are by-products of a second rule. The tool does not touch files that
# would not change, so as outputs they would always be out of date for Make. They belong to the second rule because
# Ninja prints all outputs of a rule that fails: if that is the stamp only, an error in the model follows one line. The
# second rule only generates removed files again, under Ninja.
function(_robcogen_add_codegen target)
  _robcogen_folder(stem)
  string(REPLACE "/" "." stem ${stem})
  set(stamp ${library_OUTPUT_DIR}/${stem}.stamp)
  set(depfile ${library_OUTPUT_DIR}/${stem}.d)
  set(complete ${library_OUTPUT_DIR}/${stem}.complete)
  _robcogen_generate_arguments(arguments)
  cmake_path(GET library_MODEL FILENAME document)
  set(generate robcogen::robcogen generate ${library_MODEL} -o ${library_OUTPUT_DIR} ${arguments})
  # DEPENDS, not MAIN_DEPENDENCY: two robots may have the same document.
  add_custom_command(
    OUTPUT ${stamp}
    COMMAND ${generate} --depfile ${depfile} --depfile-target ${stamp} --stamp ${stamp}
    DEPENDS robcogen::robcogen ${library_MODEL} ${library_DESIRED} ${library_DEPENDS}
    DEPFILE ${depfile}
    COMMENT "Generating ${library_NAME} from ${document}"
    VERBATIM)
  set(files ${headers} ${sources} ${c_headers} ${c_sources} ${c_casadi} ${c_checks} ${gpu_headers} ${gpu_sources} ${python_files})
  file(GENERATE OUTPUT ${library_OUTPUT_DIR}/${stem}.expected CONTENT "${files}")
  list(TRANSFORM generate REPLACE "^robcogen::robcogen$" "$<TARGET_FILE:robcogen::robcogen>")
  add_custom_command(
    OUTPUT ${complete}
    BYPRODUCTS ${files}
    COMMAND ${CMAKE_COMMAND} -DEXPECTED=${library_OUTPUT_DIR}/${stem}.expected -DCOMPLETE=${complete} -P
            ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/RobcogenComplete.cmake ${generate}
    DEPENDS ${stamp}
    COMMENT "Completing ${library_NAME}"
    VERBATIM)
  add_custom_target(${target} DEPENDS ${complete})
  set_target_properties(${target} PROPERTIES FOLDER robots)
  _robcogen_join_umbrella(robcogen_codegen ${target})
endfunction()

# If the call has the keyword, appends `option` and the keyword's values, as one text, to the list `arguments`.
macro(_robcogen_append_joined arguments keyword option separator)
  if(NOT "${library_${keyword}}" STREQUAL "")
    list(JOIN library_${keyword} "${separator}" joined)
    list(APPEND ${arguments} ${option} "${joined}")
  endif()
endmacro()

# Sets `result` to the options that remove joints from the robot.
function(_robcogen_change_arguments result)
  set(arguments "")
  _robcogen_append_joined(arguments LOCK --lock " ")
  _robcogen_append_joined(arguments KEEP --keep ",")
  set(${result} "${arguments}" PARENT_SCOPE)
endfunction()

# Sets `result` to the options of `robcogen generate` that correspond to the keywords of the call.
function(_robcogen_generate_arguments result)
  set(arguments --name ${library_NAME})
  if(NOT "${library_NAMESPACE}" STREQUAL "")
    list(APPEND arguments --namespace ${library_NAMESPACE})
  endif()
  if(NOT "${library_DESIRED}" STREQUAL "")
    list(APPEND arguments --desired ${library_DESIRED})
  endif()
  if(NOT "${library_SRDF}" STREQUAL "")
    list(APPEND arguments --srdf ${library_SRDF})
  endif()
  if(library_ALGORITHMS)
    list(APPEND arguments --algorithms ${library_ALGORITHMS})
  endif()
  _robcogen_derivative_options(derivatives)
  list(APPEND arguments ${derivatives})
  _robcogen_append_joined(arguments FUNCTIONS --function " ")
  _robcogen_append_joined(arguments FRAMES --frames ",")
  _robcogen_append_joined(arguments CONTACTS --contacts ",")
  _robcogen_append_joined(arguments INVERSE_KINEMATICS --inverse-kinematics ",")
  if(library_BATCH)
    list(APPEND arguments --batch)
  endif()
  if(library_SINGLE_PRECISION)
    list(APPEND arguments --single-precision)
  endif()
  if(library_COMPATIBILITY)
    list(APPEND arguments --compatibility ${library_COMPATIBILITY} --include-path ${library_INCLUDE_PATH})
  endif()
  if(NOT "${library_VAMP}" STREQUAL "")
    list(APPEND arguments --vamp ${library_VAMP})
  endif()
  if(library_levels)
    list(APPEND arguments --processors ${library_levels})
  endif()
  foreach(dir IN LISTS library_IMPORT_DIRS)
    cmake_path(ABSOLUTE_PATH dir BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    list(APPEND arguments -I ${dir})
  endforeach()
  _robcogen_change_arguments(changes)
  list(APPEND arguments ${changes})
  if(NOT "${library_PARAMETERS}" STREQUAL "")
    list(JOIN library_PARAMETERS "," parameters)
    list(APPEND arguments --parameters ${parameters})
  endif()
  if(library_FLOATING_BASE)
    list(APPEND arguments --floating-base)
  endif()
  if(library_SNAP_ANGLES)
    list(APPEND arguments --snap-angles)
  endif()
  if(library_PASSIVE_FORCES)
    list(APPEND arguments --passive-forces)
  endif()
  if(library_ROBOT)
    list(APPEND arguments --robot ${library_ROBOT})
  endif()
  if(NOT "${library_FRICTION_VELOCITY}" STREQUAL "")
    list(APPEND arguments --friction-velocity ${library_FRICTION_VELOCITY})
  endif()
  foreach(language IN LISTS library_LANGUAGES)
    list(APPEND arguments --language ${language})
  endforeach()
  if(library_CHECKS_C)
    list(APPEND arguments --c-selfcheck)
  endif()
  if(MSVC)
    list(APPEND arguments --error-format msvc)
  endif()
  set(${result} ${arguments} ${library_OPTIONS} PARENT_SCOPE)
endfunction()

# Adds the target of a robot without C++. The file names of the other languages depend on the model, which the
# configuration does not read.
function(_robcogen_add_text)
  _robcogen_add_codegen(${library_TARGET}_codegen)
  _robcogen_exclusion(exclusion)
  if(exclusion)
    add_custom_target(${library_TARGET})
  else()
    add_custom_target(${library_TARGET} ALL)
  endif()
  add_dependencies(${library_TARGET} ${library_TARGET}_codegen)
  _robcogen_add_c_library()
  _robcogen_add_gpu_libraries()
endfunction()

# Sets `result` to the optimisation of generated units: -O2 in each configuration without optimisation, because a kernel
# is five times slower without it, and debugging it is rarely useful. Other options, such as sanitizers, are kept.
function(_robcogen_optimisation result)
  set(${result} "" PARENT_SCOPE)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "^(GNU|Clang|AppleClang)$")
    return()
  endif()
  set(asked "(^|[ ;])-O([123sz]|fast)?($|[ ;])")
  get_property(of_directory DIRECTORY PROPERTY COMPILE_OPTIONS)
  if("${library_COMPILE_OPTIONS}" MATCHES "(^|;)-O" OR "${of_directory}" MATCHES "${asked}")
    return()
  endif()
  get_property(multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
  set(configurations "${CMAKE_BUILD_TYPE}")
  if(multi_config)
    set(configurations ${CMAKE_CONFIGURATION_TYPES})
  endif()
  set(options "")
  foreach(configuration IN LISTS configurations)
    string(TOUPPER "${configuration}" upper)
    if(NOT "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${upper}}" MATCHES "${asked}")
      list(APPEND options $<$<CONFIG:${configuration}>:-O2>)
    endif()
  endforeach()
  if(NOT configurations AND NOT "${CMAKE_CXX_FLAGS}" MATCHES "${asked}")
    set(options -O2)
  endif()
  set(${result} "${options}" PARENT_SCOPE)
endfunction()

# Adds the headers below `folder`, their include root, to the target as a file set, which can be installed. CMake 3.22 has
# no file sets.
function(_robcogen_add_headers target folder)
  set_property(TARGET ${target} PROPERTY ROBCOGEN_INCLUDE_ROOT ${folder})
  if(CMAKE_VERSION VERSION_LESS 3.23)
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${folder}>)
  else()
    target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${folder} FILES ${ARGN})
  endif()
endfunction()

function(_robcogen_add_library target)
  _robcogen_exclusion(exclusion)
  add_library(${target} STATIC ${exclusion} ${sources})
  add_library(${PROJECT_NAME}::${target} ALIAS ${target})
  add_dependencies(${target} ${target}_codegen)
  _robcogen_add_headers(${target} ${library_OUTPUT_DIR} ${headers})
  target_link_libraries(${target} PUBLIC robcogen::runtime)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # With it, programs that use two models of one name do not link.
  target_compile_definitions(${target} INTERFACE ROBCOGEN_REFERS_TO_MODEL)
  # gcc packs neighbouring scalars of the straight-line kernels into vectors, and loses more in shuffles than it gains; the
  # generator packs where it is profitable. Renaming registers saves copies: one instruction in forty. The other disabled
  # passes take a quarter of gcc's time without effect: straight-line code has no jumps, no values that depend on
  # them and no dead stores, and processors reorder instructions themselves; where scheduling is faster,
  # RobcogenProcessors.cmake enables it. Without -fno-exceptions, gcc treats intrinsics as calls that may throw and refers
  # to the handlers, as clang does with assertions. For kernels with thousands of values, register allocation takes half of
  # gcc's time if it considers 500 values at once; with 100 the code is as fast. (One line: other files read it.)
  set(of_gcc -fno-tree-slp-vectorize -frename-registers -fno-tree-dse -fno-dse -fno-schedule-insns2 -fno-tree-pta -fno-tree-pre -fno-code-hoisting -fno-tree-dominator-opts -fno-thread-jumps -fno-tree-vrp -fno-exceptions --param=lra-max-considered-reload-pseudos=100)
  _robcogen_optimisation(optimisation)
  target_compile_options(
    ${target} PRIVATE ${optimisation} "$<$<CXX_COMPILER_ID:GNU>:${of_gcc}>"
                      "$<$<CXX_COMPILER_ID:Clang,AppleClang>:-fno-exceptions>" ${library_COMPILE_OPTIONS})
  # Each algorithm has its own unit, so that rebuilds are small and parallel.
  set_target_properties(
    ${target}
    PROPERTIES ROBCOGEN_MODEL ${library_MODEL}
               ROBCOGEN_NAME ${library_NAME}
               ROBCOGEN_NAMESPACE "${library_NAMESPACE}"
               ROBCOGEN_INVERSE_KINEMATICS "${library_INVERSE_KINEMATICS}"
               ROBCOGEN_GROUPS "${library_groups}"
               ROBCOGEN_LEVELS "${library_levels}"
               FOLDER robots
               POSITION_INDEPENDENT_CODE ON
               UNITY_BUILD OFF
               CXX_CLANG_TIDY "")
endfunction()

function(_robcogen_add_selfcheck target)
  _robcogen_exclusion(exclusion)
  add_executable(${target} ${exclusion})
  _robcogen_link_harness(${target} robcogen::selfcheck_harness)
  _robcogen_add_checks(checks)
  target_link_libraries(${target} PRIVATE ${checks})
  _robcogen_set_selfcheck_options(${target})
  _robcogen_run_selfcheck(${target} robot ${library_TARGET})
endfunction()

# A test program compiles longer than it runs: builds of this project do not optimise it.
function(_robcogen_set_test_options target)
  target_compile_options(${target} PRIVATE ${ROBCOGEN_TEST_OPTIONS})
endfunction()

# The same for self-checks, which include the same headers.
function(_robcogen_set_selfcheck_options target)
  _robcogen_set_test_options(${target})
  if(TARGET robcogen_selfcheck_headers AND ROBCOGEN_TEST_OPTIONS)
    target_precompile_headers(${target} REUSE_FROM robcogen_selfcheck_headers)
  endif()
endfunction()

# Sets `result` to the compiler flags that this directory and its configurations give to every target.
function(_robcogen_directory_flags result)
  get_property(flags DIRECTORY PROPERTY COMPILE_OPTIONS)
  list(PREPEND flags ${CMAKE_CXX_FLAGS})
  foreach(configuration IN LISTS CMAKE_BUILD_TYPE CMAKE_CONFIGURATION_TYPES)
    string(TOUPPER "${configuration}" configuration)
    list(APPEND flags ${CMAKE_CXX_FLAGS_${configuration}})
  endforeach()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

# Sets `result` to the library of the checks that all self-checks call. It is compiled once for the compiler flags of this
# directory, which may change the layout of types of the standard library.
function(_robcogen_add_checks result)
  _robcogen_directory_flags(flags)
  get_property(definitions DIRECTORY PROPERTY COMPILE_DEFINITIONS)
  string(MD5 hash "${flags};${definitions}")
  string(SUBSTRING ${hash} 0 8 hash)
  set(target robcogen_checks_${hash})
  set(${result} ${target} PARENT_SCOPE)
  if(TARGET ${target})
    return()
  endif()
  add_library(${target} STATIC EXCLUDE_FROM_ALL)
  target_link_libraries(${target} PRIVATE robcogen::checks_harness)
  _robcogen_set_selfcheck_options(${target})
  set_target_properties(${target} PROPERTIES FOLDER robots POSITION_INDEPENDENT_CODE ON)
endfunction()

# Sets `result` to whether ctest can run the programs of this library: a cross-built program needs an emulator, and a
# program outside of `all` is not built before ctest runs.
function(_robcogen_can_run result)
  set(${result} ON PARENT_SCOPE)
  if(library_EXCLUDE_FROM_ALL OR (CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR))
    set(${result} OFF PARENT_SCOPE)
  endif()
endfunction()

# Adds the ctest of a self-check, with this label, for this library.
function(_robcogen_run_selfcheck target label library)
  _robcogen_can_run(can_run)
  if(NOT can_run)
    return()
  endif()
  set(arguments "")
  if(NOT "${library_TEST_SEED}" STREQUAL "")
    list(APPEND arguments --seed ${library_TEST_SEED})
  endif()
  if(NOT "${library_TEST_SAMPLES}" STREQUAL "")
    list(APPEND arguments --samples ${library_TEST_SAMPLES})
  endif()
  add_test(NAME ${library}.selfcheck COMMAND ${target} ${arguments})
  set_tests_properties(${library}.selfcheck PROPERTIES LABELS ${label} SKIP_RETURN_CODE 77)
endfunction()

function(_robcogen_add_allocations target)
  _robcogen_exclusion(exclusion)
  add_executable(${target} ${exclusion})
  _robcogen_link_harness(${target} robcogen::allocations_harness)
  _robcogen_run_allocations(${library_TARGET})
endfunction()

# Adds the ctest of <library>_allocations.
function(_robcogen_run_allocations library)
  _robcogen_can_run(can_run)
  if(can_run)
    add_test(NAME ${library}.allocations COMMAND ${library}_allocations)
    set_tests_properties(${library}.allocations PROPERTIES LABELS robot)
  endif()
endfunction()

# Adds the ctest that checks the compiled files of a library, in C++ or in C, with this label.
function(_robcogen_add_real_time_check label library)
  set(language CXX)
  _robcogen_folder(folder)
  set(kernels ${library_OUTPUT_DIR}/${folder}/kernel)
  if(library STREQUAL "${library_TARGET}_c")
    set(language C)
    _robcogen_c_prefix(prefix)
    set(kernels ${library_OUTPUT_DIR}/c/${prefix}_c)
  endif()
  if(library_EXCLUDE_FROM_ALL OR NOT CMAKE_${language}_COMPILER_ID MATCHES "^(GNU|Clang)$")
    return()
  endif()
  if(CMAKE_${language}_COMPILER_ID STREQUAL "GNU" OR CMAKE_${language}_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    target_compile_options(${library} PRIVATE -fstack-usage)
  endif()
  set(limit 65536)
  if(library_BATCH AND language STREQUAL "CXX")
    set(limit 262144)
  endif()
  if(NOT "${library_TEST_STACK_LIMIT}" STREQUAL "")
    set(limit ${library_TEST_STACK_LIMIT})
  endif()
  add_test(
    NAME ${library}.real_time
    COMMAND
      ${CMAKE_COMMAND} -DLIBRARY=$<TARGET_FILE:${library}> -DKERNELS=${kernels} -DLANGUAGE=${language}
      "-DOBJECTS=$<JOIN:$<TARGET_OBJECTS:${library}>,,>" -DNM=${CMAKE_NM} -DSTACK_LIMIT=${limit} -P
      ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/RobcogenRealTime.cmake)
  set_tests_properties(${library}.real_time PROPERTIES LABELS ${label})
endfunction()

function(_robcogen_add_bench target)
  find_package(benchmark QUIET)
  find_package(Threads QUIET)
  if(NOT TARGET benchmark::benchmark)
    return()
  endif()
  add_executable(${target} EXCLUDE_FROM_ALL)
  _robcogen_link_harness(${target} robcogen::bench_harness)
  target_link_libraries(${target} PRIVATE benchmark::benchmark Threads::Threads)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" configuration)
  set(flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${configuration}} $<JOIN:$<TARGET_PROPERTY:${library_TARGET},COMPILE_OPTIONS>, >")
  target_compile_definitions(${target} PRIVATE "ROBCOGEN_BENCH_FLAGS=\"${flags}\"")
  set_property(GLOBAL APPEND PROPERTY ROBCOGEN_BENCH_TARGETS ${target})
  _robcogen_join_umbrella(robcogen_bench ${target})
endfunction()

# Builds `target` from a harness that is written once for all robots: its sources are those of the interface target
# `harness`, and these definitions select the robot. The library is that in C++ unless another argument names the one in C,
# which has neither processor levels nor functions over many states.
function(_robcogen_link_harness target harness)
  set(library ${library_TARGET})
  if(ARGC GREATER 2)
    set(library ${ARGV2})
  endif()
  target_link_libraries(${target} PRIVATE ${library} ${harness})
  string(JOIN "::" qualified ${library_NAMESPACE} ${library_NAME})
  _robcogen_folder(folder)
  set(robot_header ${folder}/${library_NAME}.h)
  _robcogen_header(${folder} reflection reflection_header)
  target_compile_definitions(
    ${target} PRIVATE ROBCOGEN_ROBOT_HEADER=<${robot_header}> ROBCOGEN_REFLECTION_HEADER=<${reflection_header}>
                      ROBCOGEN_ROBOT_NAMESPACE=${qualified})
  if(library_levels AND library STREQUAL "${library_TARGET}")
    target_compile_definitions(${target} PRIVATE ROBCOGEN_ROBOT_HAS_LEVELS)
  endif()
  if(library_SINGLE_PRECISION OR NOT library STREQUAL "${library_TARGET}")
    target_compile_definitions(${target} PRIVATE ROBCOGEN_ROBOT_HAS_SINGLE_PRECISION)
  endif()
  if(library_BATCH AND library STREQUAL "${library_TARGET}")
    _robcogen_header(${folder} batch batch_header)
    target_compile_definitions(${target} PRIVATE ROBCOGEN_BATCH_HEADER=<${batch_header}>)
  endif()
  set_target_properties(${target} PROPERTIES FOLDER robots)
endfunction()

function(_robcogen_exclusion result)
  set(${result} "" PARENT_SCOPE)
  if(library_EXCLUDE_FROM_ALL)
    set(${result} EXCLUDE_FROM_ALL PARENT_SCOPE)
  endif()
endfunction()

function(_robcogen_join_umbrella umbrella target)
  if(NOT TARGET ${umbrella})
    add_custom_target(${umbrella})
  endif()
  add_dependencies(${umbrella} ${target})
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/RobcogenTransforms.cmake)
