# robcogen_add_transforms: makes a static library from a document of rigid motions or of coordinate transforms, without a
# robot.
#
#     robcogen_add_transforms(
#       TARGET euler                # the library; alias ${PROJECT_NAME}::euler
#       MOTIONS euler.motdsl        # relative poses of frames: each motion gives a transform and its inverse; or
#       TRANSFORMS euler.ctdsl      # coordinate transforms as products of primitive ones
#       [DESIRED euler.dtdsl]       # the transforms to generate, between any frames that the document connects
#       [DERIVATIVES function:input…]
#                                   # derivatives by `variables` or `parameters`: transforms.homogeneous.A_X_B:variables
#       [NAME ident] [NAMESPACE a::b] [SINGLE_PRECISION] [LANGUAGES cpp …] [PYTHON] [JAX] [TORCH] [CASADI] [DEPENDS file|target…]
#       [COMPILE_OPTIONS option…] [OUTPUT_DIR dir] [NO_TESTS] [TEST_SEED n] [TEST_SAMPLES n] [EXCLUDE_FROM_ALL]
#       [EXPORT_FILES variable] [OPTIONS flag…])
#
# The other keywords are those of robcogen_add_robot. Defines, for TARGET euler in C++:
#     euler            the static library; #include <euler/euler.h>
#     euler_codegen    the generated files only
#     euler_selfcheck  compares every transform with its product of primitives, computed in long double; ctest
#                      euler.selfcheck, label `transforms` (when BUILD_TESTING is on), and with it euler.real_time
include_guard(GLOBAL)

function(robcogen_add_transforms)
  set(flags SINGLE_PRECISION DOUBLE_ONLY PYTHON JAX TORCH CASADI NO_TESTS EXCLUDE_FROM_ALL)
  set(values TARGET MOTIONS TRANSFORMS DESIRED NAME NAMESPACE OUTPUT_DIR TEST_SEED TEST_SAMPLES EXPORT_FILES)
  set(lists DERIVATIVES GRADIENTS TANGENTS LANGUAGES DEPENDS COMPILE_OPTIONS OPTIONS)
  cmake_parse_arguments(PARSE_ARGV 0 library "${flags}" "${values}" "${lists}")

  set(library_CALL robcogen_add_transforms)
  _robcogen_refuse_repeated("${values}" ${ARGV})
  _robcogen_check_keywords(${values} ${lists} ${flags})
  _robcogen_choose_document()
  _robcogen_complete_arguments()
  _robcogen_choose_gradients()
  _robcogen_check_derivatives()
  _robcogen_check_elements(LANGUAGES cpp c matlab maxima javascript)
  _robcogen_check_cpp()
  _robcogen_check_c()
  _robcogen_check_python()
  _robcogen_check_documents(${document_keyword})
  _robcogen_check_names()
  _robcogen_require_tool()
  _robcogen_check_cpp_compiler()

  set(groups transforms)
  if(library_DERIVATIVES OR library_GRADIENTS OR library_TANGENTS)
    list(APPEND groups derivatives)
  endif()
  _robcogen_c_files("${groups}")
  _robcogen_python_files()
  if(NOT "cpp" IN_LIST library_LANGUAGES)
    _robcogen_add_text()
    return()
  endif()
  _robcogen_folder(folder)
  _robcogen_generated_transforms(${folder} headers sources)
  list(TRANSFORM headers PREPEND ${library_OUTPUT_DIR}/)
  list(TRANSFORM sources PREPEND ${library_OUTPUT_DIR}/)
  _robcogen_add_codegen(${library_TARGET}_codegen)
  _robcogen_add_library(${library_TARGET})
  _robcogen_add_c_library()
  _robcogen_add_python()
  if(BUILD_TESTING AND NOT library_NO_TESTS)
    _robcogen_add_transforms_selfcheck(${library_TARGET}_selfcheck)
    _robcogen_add_real_time_check(transforms ${library_TARGET})
  endif()
  if(NOT "${library_EXPORT_FILES}" STREQUAL "")
    set(${library_EXPORT_FILES} ${headers} ${sources} ${c_headers} ${c_sources} ${c_casadi} ${python_files} PARENT_SCOPE)
  endif()
endfunction()

# Sets library_MODEL to the document that MOTIONS or TRANSFORMS names, and document_keyword to that keyword.
function(_robcogen_choose_document)
  if(NOT "${library_MOTIONS}" STREQUAL "" AND NOT "${library_TRANSFORMS}" STREQUAL "")
    _robcogen_refuse("MOTIONS and TRANSFORMS exclude each other")
  elseif(NOT "${library_MOTIONS}" STREQUAL "")
    set(keyword MOTIONS)
    set(wanted .motdsl)
  elseif(NOT "${library_TRANSFORMS}" STREQUAL "")
    set(keyword TRANSFORMS)
    set(wanted .ctdsl)
  else()
    _robcogen_refuse("MOTIONS or TRANSFORMS is missing")
  endif()
  cmake_path(GET library_${keyword} EXTENSION LAST_ONLY extension)
  if(NOT extension STREQUAL wanted)
    _robcogen_refuse("${keyword} must be a ${wanted} document, not '${extension}': ${library_${keyword}}")
  endif()
  set(library_MODEL "${library_${keyword}}" PARENT_SCOPE)
  set(document_keyword ${keyword} PARENT_SCOPE)
endfunction()

# Sets `headers` and `sources` to the files of a library, relative to its include root.
function(_robcogen_generated_transforms folder headers sources)
  cmake_path(GET folder FILENAME name)
  set(header_list ${folder}/${name}.h ${folder}/detail/kernels.h ${folder}/detail/functions.inc ${folder}/kernel/transforms.h)
  foreach(stem model types reflection)
    _robcogen_header(${folder} ${stem} header)
    list(APPEND header_list ${header})
  endforeach()
  set(source_list ${folder}/transforms.cpp)
  if(library_DERIVATIVES OR library_GRADIENTS OR library_TANGENTS)
    list(APPEND header_list ${folder}/kernel/derivatives.h)
    list(APPEND source_list ${folder}/derivatives.cpp)
  endif()
  set(${headers} ${header_list} PARENT_SCOPE)
  set(${sources} ${source_list} PARENT_SCOPE)
endfunction()

function(_robcogen_add_transforms_selfcheck target)
  _robcogen_exclusion(exclusion)
  add_executable(${target} ${exclusion})
  target_link_libraries(${target} PRIVATE ${library_TARGET} robcogen::transforms_selfcheck_harness)
  _robcogen_set_test_options(${target})
  string(JOIN "::" qualified ${library_NAMESPACE} ${library_NAME})
  _robcogen_folder(folder)
  _robcogen_header(${folder} reflection reflection_header)
  target_compile_definitions(
    ${target} PRIVATE ROBCOGEN_REFLECTION_HEADER=<${reflection_header}> ROBCOGEN_TRANSFORMS_NAMESPACE=${qualified})
  set_target_properties(${target} PROPERTIES FOLDER transforms)
  _robcogen_run_selfcheck(${target} transforms ${library_TARGET})
endfunction()
