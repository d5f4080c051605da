# Wrong calls; ../calls.cmake says how they are read.

#### batch_levels_without_batch
# robcogen_add_robot(TARGET leg): BATCH_LEVELS needs BATCH
robcogen_add_robot(TARGET leg MODEL hyl.kindsl BATCH_LEVELS avx2)

#### batch_without_cpp
# robcogen_add_robot(TARGET hyl): BATCH is for C++: LANGUAGES must include cpp
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES matlab BATCH)

#### c_without_compiler
# robcogen_add_robot(TARGET hyl): LANGUAGES c needs a C compiler: write enable_language(C), or project(… LANGUAGES C CXX),
# before this call
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES cpp c)

#### casadi_without_c
# robcogen_add_robot(TARGET hyl): CASADI needs the library in C: LANGUAGES must include c
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl CASADI)

#### compatibility_with_another
# robcogen_add_robot(TARGET hyl): COMPATIBILITY: 'rbdl' is not one of robcogen
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl COMPATIBILITY rbdl)

#### compatibility_without_cpp
# robcogen_add_robot(TARGET hyl): COMPATIBILITY is for C++: LANGUAGES must include cpp
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES matlab COMPATIBILITY robcogen)

#### gpu_architecture_of_another_kind
# robcogen_add_robot(TARGET leg): GPU_ARCHITECTURES: 'sm_90' is not an architecture of CUDA, such as 80, 90-real or native
robcogen_add_robot(TARGET leg MODEL hyl.kindsl LANGUAGES gpu GPU_ARCHITECTURES 80 sm_90)

#### gpu_architectures_without_gpu
# robcogen_add_robot(TARGET leg): GPU_ARCHITECTURES needs gpu among LANGUAGES
robcogen_add_robot(TARGET leg MODEL hyl.kindsl GPU_ARCHITECTURES 90)

#### include_path_above
# robcogen_add_robot(TARGET hyl): INCLUDE_PATH is a folder as #include lines name it, such as iit/robots/hyq, not '../hyl'
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl COMPATIBILITY robcogen INCLUDE_PATH ../hyl)

#### include_path_without_compatibility
# robcogen_add_robot(TARGET hyl): INCLUDE_PATH needs COMPATIBILITY
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl INCLUDE_PATH iit/robots/hyl)

#### cross_without_tool
# that runs on this machine. Set ROBCOGEN_HOST_TOOL to the path of one; from the source tree,
# ROBCOGEN_BUILD_HOST_TOOL=ON builds it.
unset(ROBCOGEN_HOST_TOOL CACHE)
set(CMAKE_CROSSCOMPILING TRUE)
set(CMAKE_FIND_USE_CMAKE_SYSTEM_PATH OFF)
set(ENV{PATH} "")
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)

#### desired_not_found
# robcogen_add_robot(TARGET hyl): DESIRED does not exist: @DIR@/list-NOTFOUND
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DESIRED list-NOTFOUND)

#### flag_with_value
# robcogen_add_robot(TARGET hyl): unknown argument 'OFF'; the keywords are TARGET MODEL ROBOT SRDF DESIRED NAME
robcogen_add_robot(TARGET hyl MODEL hyl.urdf FLOATING_BASE OFF)

#### host_tool_missing
# ROBCOGEN_HOST_TOOL must be the absolute path of a robcogen executable; it is '@DIR@/robcogen'
set(ROBCOGEN_HOST_TOOL ${CMAKE_CURRENT_SOURCE_DIR}/robcogen)
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)

#### host_tool_of_other_version
# '@DIR@/robcogen' reports version 0.4.2
set(ROBCOGEN_HOST_TOOL ${CMAKE_CURRENT_SOURCE_DIR}/robcogen)
file(WRITE ${ROBCOGEN_HOST_TOOL} "#!/bin/sh\necho robcogen 0.4.2\n")
file(CHMOD ${ROBCOGEN_HOST_TOOL} PERMISSIONS OWNER_READ OWNER_EXECUTE)
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)

#### keyword_without_value
# robcogen_add_robot(TARGET hyl): missing value: ALGORITHMS and DESIRED
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DESIRED ALGORITHMS)

#### languages_off
# robcogen_add_robot(TARGET hyl): LANGUAGES: 'OFF' is not one of cpp c gpu matlab maxima javascript
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES OFF)

#### missing_desired
# robcogen_add_robot(TARGET hyl): DESIRED does not exist: @DIR@/hyl.dtdsl
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DESIRED hyl.dtdsl)

#### missing_model
# robcogen_add_robot(TARGET hyl): MODEL does not exist: @DIR@/hly.kindsl (name its rule in DEPENDS if the build generates it)
robcogen_add_robot(TARGET hyl MODEL hly.kindsl)

#### model_twice
# robcogen_add_robot(TARGET hyl): MODEL is given 2 times; it has one value
robcogen_add_robot(TARGET hyl MODEL hly.kindsl MODEL hyl.kindsl)

#### name_not_an_identifier
# robcogen_add_robot(TARGET hyl): NAME '3-legs' is not an identifier
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAME 3-legs)

#### name_of_function
# robcogen_add_robot(TARGET hyl): NAME 'sincos' is a macro or a function of system headers: give another NAME
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAME sincos)

#### name_reserved
# robcogen_add_robot(TARGET hyl): NAME 'union' is a reserved word of the generated code
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAME union)

#### name_taken
# robcogen_add_robot(TARGET leg): NAME 'hyl' is taken by target 'hyl': give this one a NAMESPACE or another NAME
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_hyl hyl)
robcogen_add_robot(TARGET leg MODEL hyl.kindsl NAME hyl)

#### namespace_false_word
# robcogen_add_robot(TARGET leg): NAME 'N::hyl' is taken by target 'left': give this one another NAMESPACE or NAME
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_N::hyl left)
robcogen_add_robot(TARGET leg MODEL hyl.kindsl NAME hyl NAMESPACE N)

#### namespace_not_an_identifier
# robcogen_add_robot(TARGET hyl): NAMESPACE 'b.c' is not an identifier
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAMESPACE a::b.c)

#### namespace_of_macro
# robcogen_add_robot(TARGET hyl): NAMESPACE 'linux' is a macro or a function of system headers: give another NAMESPACE
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAMESPACE robots::linux)

#### namespace_taken
# robcogen_add_robot(TARGET leg): NAME 'left::hyl' is taken by target 'left_leg': give this one another NAMESPACE or NAME
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_hyl hyl)
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_left::hyl left_leg)
robcogen_add_robot(TARGET leg MODEL hyl.kindsl NAME hyl NAMESPACE left)

#### namespace_with_gap
# robcogen_add_robot(TARGET hyl): NAMESPACE '' is not an identifier
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAMESPACE a::::b)

#### no_model
# robcogen_add_robot(TARGET hyl): MODEL is missing
robcogen_add_robot(TARGET hyl)

#### no_target
# robcogen_add_robot(): TARGET is missing
robcogen_add_robot(MODEL hyl.kindsl)

#### other_model
# robcogen_add_robot(TARGET hyl): MODEL must be a .kindsl document, a .urdf, an .sdf, an .xml (URDF or MJCF) or a .urdf.xacro, not '.yaml': @DIR@/hyl.yaml
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/hyl.yaml "")
robcogen_add_robot(TARGET hyl MODEL hyl.yaml)

#### positional
# robcogen_add_robot(): unknown argument 'hyl'; the keywords are
robcogen_add_robot(hyl MODEL hyl.kindsl)

#### processors_and_options
# robcogen_add_robot(TARGET hyl): PROCESSORS, and COMPILE_OPTIONS that choose a processor or no optimisation, exclude each other
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl PROCESSORS avx2 COMPILE_OPTIONS -march=native)

#### processors_unknown
# robcogen_add_robot(TARGET hyl): PROCESSORS: 'avx' is not one of baseline avx2 avx512
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl PROCESSORS avx)

#### python_without_cpp
# robcogen_add_robot(TARGET hyl): PYTHON needs the library in C++: LANGUAGES must include cpp
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES matlab PYTHON)

#### python_word
# robcogen_add_robot(TARGET hyl): NAME 'lambda' is a Python keyword, which cannot name a module: give another NAME
robcogen_add_robot(TARGET hyl NAME lambda MODEL hyl.kindsl PYTHON)

#### name_of_standard_module
# robcogen_add_robot(TARGET hyl): NAME 'copy' is a module of Python's standard library, which yours would hide: give another NAME
robcogen_add_robot(TARGET hyl NAME copy MODEL hyl.kindsl PYTHON)

#### samples_negative
# robcogen_add_robot(TARGET hyl): TEST_SAMPLES must be a whole number, not '-5'
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl TEST_SAMPLES -5)

#### samples_not_a_number
# robcogen_add_robot(TARGET hyl): TEST_SAMPLES must be a whole number, not 'many'
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl TEST_SAMPLES many)

#### samples_zero
# robcogen_add_robot(TARGET hyl): TEST_SAMPLES must be positive, not '0'
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl TEST_SAMPLES 0)

#### shared
# robcogen_add_robot(TARGET hyl): SHARED is not supported: generated code is a static library
robcogen_add_robot(TARGET hyl SHARED MODEL hyl.kindsl)

#### target_exists
# robcogen_add_robot(TARGET hyl): a target with this name already exists
add_custom_target(hyl)
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)

#### target_reserved
# robcogen_add_robot(TARGET double): NAME 'double' is a reserved word of the generated code
robcogen_add_robot(TARGET double MODEL hyl.kindsl)

#### unknown_algorithm
# robcogen_add_robot(TARGET hyl): ALGORITHMS: 'inverse_dynamic' is not one of inverse_dynamics bias_forces passive_forces forward_dynamics joint_space_inertia joint_space_inertia_factor coriolis_matrix control_terms inverse_dynamics_derivatives inverse_dynamics_gradient inverse_dynamics_second_derivatives forward_dynamics_derivatives centroidal energy centroidal_bias contacts constrained_forward_dynamics_derivatives operational_space regressor base_regressor energy_regressor slotine_li_regressor transforms jacobians jacobian_references jacobians_with_base jacobian_derivatives all_frames inverse_kinematics collision velocities accelerations world world_centroidal fused all
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl ALGORITHMS jacobians inverse_dynamic)

#### unknown_keyword
# robcogen_add_robot(TARGET hyl): unknown argument 'MODLE' 'hyl.kindsl'; the keywords are TARGET MODEL ROBOT SRDF DESIRED NAME
robcogen_add_robot(TARGET hyl MODLE hyl.kindsl)

#### unknown_language
# robcogen_add_robot(TARGET hyl): LANGUAGES: 'fortran' is not one of cpp c gpu matlab maxima javascript
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES cpp fortran)

#### robot_keyword
# robcogen_add_robot(TARGET hyl): ROBOT is for MJCF and SDF, whose scenes have several robots: @DIR@/hyl.kindsl
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl ROBOT base)

#### urdf_keyword
# robcogen_add_robot(TARGET hyl): FLOATING_BASE is for URDF; a robot document states this itself: @DIR@/hyl.kindsl
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl FLOATING_BASE)

#### vamp_without_cpp
# robcogen_add_robot(TARGET hyl): VAMP is for C++: LANGUAGES must include cpp
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES matlab VAMP tool)

#### wrong_derivative
# robcogen_add_robot(TARGET hyl): DERIVATIVES: 'inverse_dynamics' is not function:input or function:input,input, such as inverse_dynamics:q,qd, or all
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DERIVATIVES jacobians.base_J_foot:q inverse_dynamics)

#### torch_without_python
# robcogen_add_robot(TARGET hyl): TORCH needs PYTHON
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl TORCH)

#### wrong_function
# robcogen_add_robot(TARGET hyl): FUNCTIONS: 'bias_forces + gravity_forces' is not name = function + function, such as control = joint_space_inertia + bias_forces
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl FUNCTIONS bias_forces + gravity_forces)

#### xacro_args_of_urdf
# robcogen_add_robot(TARGET hyl): XACRO_ARGS is for a MODEL that xacro expands, with the extension .urdf.xacro or .xacro: @DIR@/hyl.urdf
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/hyl.urdf "")
robcogen_add_robot(TARGET hyl MODEL hyl.urdf XACRO_ARGS length:=0.7)

#### xacro_missing
# robcogen_add_robot(TARGET hyl): MODEL needs xacro, which is not on the PATH: @DIR@/hyl.urdf.xacro.
# Install it (ROS: ros-<distribution>-xacro, and source its setup.bash) or set ROBCOGEN_XACRO to its path
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/hyl.urdf.xacro "")
set(CMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH OFF)
set(CMAKE_FIND_USE_CMAKE_SYSTEM_PATH OFF)
robcogen_add_robot(TARGET hyl MODEL hyl.urdf.xacro)
