# Checks and defaults of the arguments of robcogen_add_robot and robcogen_add_transforms.
#
# These functions read the variables library_<KEYWORD> of the calling function, and library_CALL, its name. library_MODEL is
# the document of the model, whichever keyword names it. Values are compared with "": if(library_NAME) would be false for a
# NAME such as N, OFF or 0.

# Stops the configuration with a message that names the call.
function(_robcogen_refuse text)
  list(TRANSFORM library_TARGET PREPEND "TARGET ")
  message(FATAL_ERROR "${library_CALL}(${library_TARGET}): ${text}")
endfunction()

# Refuses a keyword with one value, of the list `keywords`, that is more than once among the arguments of the call, which
# follow: cmake_parse_arguments would use the last value.
function(_robcogen_refuse_repeated keywords)
  foreach(keyword IN LISTS keywords)
    set(given ${ARGN})
    list(FILTER given INCLUDE REGEX "^${keyword}$")
    list(LENGTH given count)
    if(count GREATER 1)
      _robcogen_refuse("${keyword} is given ${count} times; it has one value")
    endif()
  endforeach()
endfunction()

# Refuses arguments that are not among the keywords, and keywords without a value.
function(_robcogen_check_parsed)
  if(NOT "${library_UNPARSED_ARGUMENTS}" STREQUAL "")
    list(JOIN library_UNPARSED_ARGUMENTS "' '" unknown)
    list(JOIN ARGN " " known)
    _robcogen_refuse("unknown argument '${unknown}'; the keywords are ${known}")
  endif()
  if(library_KEYWORDS_MISSING_VALUES)
    list(JOIN library_KEYWORDS_MISSING_VALUES " and " keywords)
    _robcogen_refuse("missing value: ${keywords}")
  endif()
endfunction()

function(_robcogen_check_keywords)
  if("SHARED" IN_LIST library_UNPARSED_ARGUMENTS)
    _robcogen_refuse("SHARED is not supported: generated code is a static library; link it into your own shared library")
  endif()
  _robcogen_check_parsed(${ARGN})
  if("${library_TARGET}" STREQUAL "")
    _robcogen_refuse("TARGET is missing")
  endif()
  foreach(keyword TEST_SEED TEST_SAMPLES TEST_STACK_LIMIT)
    if(NOT "${library_${keyword}}" MATCHES "^[0-9]*$")
      _robcogen_refuse("${keyword} must be a whole number, not '${library_${keyword}}'")
    endif()
  endforeach()
  foreach(keyword TEST_SAMPLES TEST_STACK_LIMIT)
    if("${library_${keyword}}" MATCHES "^0+$")
      _robcogen_refuse("${keyword} must be positive, not '${library_${keyword}}'")
    endif()
  endforeach()
endfunction()

# Refuses every element of the list library_<keyword> that is not among the arguments.
function(_robcogen_check_elements keyword)
  foreach(element IN LISTS library_${keyword})
    if(NOT element IN_LIST ARGN)
      list(JOIN ARGN " " known)
      _robcogen_refuse("${keyword}: '${element}' is not one of ${known}")
    endif()
  endforeach()
endfunction()

# Checks the form of the elements only; the generator checks functions and inputs.
function(_robcogen_check_derivatives)
  foreach(element IN LISTS library_DERIVATIVES)
    if(NOT element MATCHES "^[^:,]+((\\.|::)[^:,]+)*:[A-Za-z_][A-Za-z0-9_]*(,[A-Za-z_][A-Za-z0-9_]*)*$")
      _robcogen_refuse("DERIVATIVES: '${element}' is not function:input or function:input,input, such as inverse_dynamics:q,qd")
    endif()
  endforeach()
endfunction()

# A file that a rule of the build generates may not exist yet: DEPENDS names the rule.
function(_robcogen_check_file keyword file)
  if(NOT "${file}" STREQUAL "" AND NOT EXISTS "${file}" AND "${library_DEPENDS}" STREQUAL "")
    _robcogen_refuse("${keyword} does not exist: ${file} (name its rule in DEPENDS if the build generates it)")
  endif()
endfunction()

# Checks that the documents exist. `keyword` is the keyword that names the model.
function(_robcogen_check_documents keyword)
  _robcogen_check_file(${keyword} "${library_MODEL}")
  _robcogen_check_file(DESIRED "${library_DESIRED}")
endfunction()

# A generated namespace must differ from the names that generated code uses.
function(_robcogen_check_identifier keyword identifier)
  set(reserved
      alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class compl
      concept const const_cast consteval constexpr constinit continue co_await co_return co_yield decltype default
      delete do double dynamic_cast else enum explicit export extern false float for friend goto if inline int long
      mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register
      reinterpret_cast requires return short signed sizeof static static_assert static_cast struct switch template this
      thread_local throw true try typedef typeid typename union unsigned using virtual void volatile wchar_t while xor
      xor_eq std Eigen robcogen)
  if(NOT identifier MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    _robcogen_refuse("${keyword} '${identifier}' is not an identifier")
  endif()
  if(identifier IN_LIST reserved)
    _robcogen_refuse("${keyword} '${identifier}' is a reserved word of the generated code")
  endif()
  # The generator's lists of these names; in an installed package they are in the folder of this file.
  foreach(list macros.inc globals.inc)
    set(file ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${list})
    if(NOT EXISTS ${file})
      set(file ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../tool/backend/common/${list})
    endif()
    # `AF_*` is a family of names, `sin~` are sin, sinf, sinl, sinf32 and so on.
    file(STRINGS ${file} lines REGEX "^\"")
    string(REGEX MATCHALL "[A-Za-z0-9_*~]+" patterns "${lines}")
    list(TRANSFORM patterns REPLACE "[*]" ".*")
    list(TRANSFORM patterns REPLACE "~" "(f|l|f16|f32|f64|f128|f32x|f64x)?")
    foreach(pattern IN LISTS patterns)
      if(identifier MATCHES "^${pattern}$")
        _robcogen_refuse("${keyword} '${identifier}' is a macro or a function of system headers: give another ${keyword}")
      endif()
    endforeach()
  endforeach()
endfunction()

function(_robcogen_check_names)
  if(TARGET "${library_TARGET}")
    _robcogen_refuse("a target with this name already exists")
  endif()
  _robcogen_check_identifier(NAME "${library_NAME}")
  string(REPLACE "::" ";" enclosing "${library_NAMESPACE}")
  foreach(identifier IN LISTS enclosing)
    _robcogen_check_identifier(NAMESPACE "${identifier}")
  endforeach()
  string(JOIN "::" qualified ${library_NAMESPACE} ${library_NAME})
  get_property(owner GLOBAL PROPERTY ROBCOGEN_OWNER_OF_${qualified})
  if(NOT "${owner}" STREQUAL "")
    set(hint "give this one a NAMESPACE or another NAME")
    if(NOT "${library_NAMESPACE}" STREQUAL "")
      set(hint "give this one another NAMESPACE or NAME")
    endif()
    _robcogen_refuse("NAME '${qualified}' is taken by target '${owner}': ${hint}")
  endif()
  set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_${qualified} ${library_TARGET})
endfunction()

# Refuses keywords that concern only C++ if the library has no C++; they would otherwise be ignored.
function(_robcogen_check_cpp)
  if("cpp" IN_LIST library_LANGUAGES)
    return()
  endif()
  foreach(keyword BATCH DOUBLE_ONLY PROCESSORS)
    if(library_${keyword})
      _robcogen_refuse("${keyword} is for C++: LANGUAGES must include cpp")
    endif()
  endforeach()
endfunction()

# Refuses a library in C++ where no project of this folder or above has enabled the language: CMake would stop at the end of
# the configuration, with variables of its own. A language that a project below has enabled is not set up here.
function(_robcogen_check_cpp_compiler)
  if("cpp" IN_LIST library_LANGUAGES AND NOT CMAKE_CXX_COMPILER_LOADED)
    _robcogen_refuse("the library needs a C++ compiler: write enable_language(CXX), or project(… LANGUAGES CXX), before this call")
  endif()
endfunction()

# Sets the defaults of omitted keywords, and makes paths absolute.
function(_robcogen_complete_arguments)
  if("${library_NAME}" STREQUAL "")
    string(MAKE_C_IDENTIFIER "${library_TARGET}" library_NAME)
  endif()
  if("${library_LANGUAGES}" STREQUAL "")
    set(library_LANGUAGES cpp)
  endif()
  if("${library_OUTPUT_DIR}" STREQUAL "")
    set(library_OUTPUT_DIR robcogen.gen/${library_TARGET})
  endif()
  cmake_path(ABSOLUTE_PATH library_OUTPUT_DIR BASE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}" NORMALIZE)
  foreach(keyword MODEL DESIRED)
    if(NOT "${library_${keyword}}" STREQUAL "")
      cmake_path(ABSOLUTE_PATH library_${keyword} BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
    endif()
  endforeach()
  foreach(variable NAME LANGUAGES OUTPUT_DIR MODEL DESIRED)
    set(library_${variable} "${library_${variable}}" PARENT_SCOPE)
  endforeach()
endfunction()
