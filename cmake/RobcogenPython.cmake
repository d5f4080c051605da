# The Python module of a robot: PYTHON of robcogen_add_robot.
#
# Defines, for TARGET hyl, the module hyl_python: hyl.abi3.so with its stub hyl.pyi in OUTPUT_DIR/python, importable by
# every Python from 3.11 on. Building it needs the headers of one of these versions, and no Python package.
include_guard(GLOBAL)

# JAX and TORCH differentiate every function, unless the call says otherwise. Every module has functions for both packages, which
# need neither when the module is built.
function(_robcogen_choose_gradients)
  foreach(keyword JAX TORCH)
    if(library_${keyword} AND NOT library_PYTHON)
      _robcogen_refuse("${keyword} needs PYTHON")
    endif()
  endforeach()
  set(asked ${library_DERIVATIVES} ${library_GRADIENTS} ${library_TANGENTS})
  if((library_JAX OR library_TORCH) AND NOT "all" IN_LIST asked)
    set(library_GRADIENTS ${library_GRADIENTS} all PARENT_SCOPE)
  endif()
endfunction()

# Finds Python, and adds the language that the generator prints to library_LANGUAGES.
function(_robcogen_check_python)
  if(NOT library_PYTHON)
    return()
  endif()
  if(NOT "cpp" IN_LIST library_LANGUAGES)
    _robcogen_refuse("PYTHON needs the library in C++: LANGUAGES must include cpp")
  endif()
  set(words False None True and as assert async await break class continue def del elif else except finally for from global if
            import in is lambda nonlocal not or pass raise return try while with yield)
  if(library_NAME IN_LIST words)
    _robcogen_refuse("NAME '${library_NAME}' is a Python keyword, which cannot name a module: give another NAME")
  endif()
  find_package(Python3 3.11 QUIET COMPONENTS Interpreter Development.Module)
  # A module of such a name would be imported by every program that has its folder in PYTHONPATH.
  get_property(standard GLOBAL PROPERTY ROBCOGEN_PYTHON_STANDARD_MODULES)
  if(NOT standard AND Python3_EXECUTABLE)
    execute_process(COMMAND ${Python3_EXECUTABLE} -c "import sys; print(*sorted(sys.stdlib_module_names), sep=';')"
                    OUTPUT_VARIABLE standard OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    set_property(GLOBAL PROPERTY ROBCOGEN_PYTHON_STANDARD_MODULES "${standard}")
  endif()
  if(library_NAME IN_LIST standard)
    _robcogen_refuse("NAME '${library_NAME}' is a module of Python's standard library, which yours would hide: give another NAME")
  endif()
  if(NOT TARGET Python3::Module)
    _robcogen_refuse(
      "PYTHON needs the headers of Python 3.11 or newer (Debian: python3-dev); set Python3_EXECUTABLE to a Python that has them")
  endif()
  set_target_properties(Python3::Module PROPERTIES IMPORTED_GLOBAL ON)
  set(library_LANGUAGES ${library_LANGUAGES} python PARENT_SCOPE)
endfunction()

# Sets python_files to the files of the module.
function(_robcogen_python_files)
  set(python_files "")
  if(library_PYTHON)
    set(python_files ${library_OUTPUT_DIR}/python/${library_NAME}.cpp ${library_OUTPUT_DIR}/python/${library_NAME}.pyi)
  endif()
  set(python_files "${python_files}" PARENT_SCOPE)
endfunction()

function(_robcogen_add_python)
  if(NOT library_PYTHON)
    return()
  endif()
  set(target ${library_TARGET}_python)
  _robcogen_exclusion(exclusion)
  list(GET python_files 0 source)
  add_library(${target} MODULE ${exclusion} ${source})
  add_dependencies(${target} ${library_TARGET}_codegen)
  target_link_libraries(${target} PRIVATE ${library_TARGET} Python3::Module)
  set(suffix .abi3.so)
  if(WIN32)
    set(suffix .pyd)
  endif()
  _robcogen_optimisation(optimisation)
  target_compile_options(${target} PRIVATE ${optimisation})
  # Functions of the library stay private, also if Python loads modules with RTLD_GLOBAL: another robot may have their names.
  if(CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    target_link_options(${target} PRIVATE LINKER:--exclude-libs,ALL)
  endif()
  set_target_properties(
    ${target}
    PROPERTIES OUTPUT_NAME ${library_NAME}
               PREFIX ""
               SUFFIX ${suffix}
               LIBRARY_OUTPUT_DIRECTORY $<1:${library_OUTPUT_DIR}/python>
               CXX_VISIBILITY_PRESET hidden
               CXX_CLANG_TIDY ""
               UNITY_BUILD OFF
               FOLDER robots)
endfunction()
