# The processors that generated code is compiled for.
#
# These functions read the variables library_<KEYWORD> of the calling function. A level is avx2 or avx512; the baseline is
# the processor that the options of the library select.

# Sets `result` to the options for a level. (A variable of this file would not be visible to callers in a directory above
# the one that includes it, as with add_subdirectory(robcogen).)
function(_robcogen_level_options level result)
  set(options -mavx2 -mfma)
  if(level STREQUAL "avx512")
    list(APPEND options -mavx512f -mavx512dq -mavx512vl)
  endif()
  set(${result} ${options} PARENT_SCOPE)
endfunction()

# Sets `result` to whether units can be compiled for levels, with a choice when the program starts.
function(_robcogen_has_levels result)
  set(${result} OFF PARENT_SCOPE)
  if(CMAKE_CXX_COMPILER_ID MATCHES "^(GNU|Clang)$" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$"
     AND NOT MSVC AND NOT CMAKE_SIZEOF_VOID_P EQUAL 4)
    set(${result} ON PARENT_SCOPE)
  endif()
endfunction()

# Sets library_levels to the levels that kernels of one state are compiled for: those of PROCESSORS, or both without it.
# There are none if options of the library or of the build choose a processor or disable optimisation, or if nothing is
# generated in C++.
function(_robcogen_choose_levels)
  set(library_levels "" PARENT_SCOPE)
  set(levels avx2 avx512)
  if(library_PROCESSORS)
    set(levels ${library_PROCESSORS})
    list(REMOVE_ITEM levels baseline)
    list(REMOVE_DUPLICATES levels)
    list(SORT levels)
  endif()
  set(chosen "(^|[ ;])-(m(arch=|cpu=|avx|fma|sse|no-|32|x32)|O0)")
  if(library_PROCESSORS AND levels AND "${library_COMPILE_OPTIONS}" MATCHES "${chosen}")
    _robcogen_refuse("PROCESSORS, and COMPILE_OPTIONS that choose a processor or no optimisation, exclude each other")
  endif()
  _robcogen_directory_flags(flags)
  set(options "${flags};${library_COMPILE_OPTIONS}")
  _robcogen_has_levels(has_levels)
  if("cpp" IN_LIST library_LANGUAGES AND has_levels AND NOT "${options}" MATCHES "${chosen}")
    set(library_levels ${levels} PARENT_SCOPE)
  endif()
endfunction()

# Sets `sources` to the units of kernels for the levels, two for each.
function(_robcogen_level_files folder sources)
  set(source_list "")
  foreach(level IN LISTS library_levels)
    list(APPEND source_list ${folder}/kernels_${level}_1.cpp ${folder}/kernels_${level}_2.cpp)
  endforeach()
  set(${sources} ${source_list} PARENT_SCOPE)
endfunction()

# Removes the levels that BATCH_LEVELS does not name from `sources`, and sets `omitted_levels` to the definitions for the
# unit that selects a level. Without AVX2, the baseline is what most machines use.
function(_robcogen_omit_levels)
  set(omitted "")
  set(levels avx2 avx512)
  if(library_BATCH_LEVELS)
    set(levels ${library_BATCH_LEVELS})
  endif()
  _robcogen_has_levels(has_levels)
  if(NOT has_levels OR NOT avx2 IN_LIST levels)
    list(APPEND levels baseline)
  endif()
  foreach(level baseline avx2 avx512)
    if(NOT level IN_LIST levels)
      list(FILTER sources EXCLUDE REGEX "/batch/[a-z_]+_${level}\\.cpp$")
      string(TOUPPER ${level} upper)
      list(APPEND omitted ROBCOGEN_WITHOUT_${upper})
    endif()
  endforeach()
  set(omitted_levels ${omitted} PARENT_SCOPE)
  set(sources ${sources} PARENT_SCOPE)
endfunction()

# Compiles each source for its processor. Sources for different processors share only C functions that the compiler does
# not inline; all other functions have internal linkage or a name with the processor in it. (See robcogen/lanes.h.)
function(_robcogen_set_levels target)
  foreach(level IN LISTS library_levels)
    string(TOUPPER ${level} upper)
    target_compile_definitions(${target} PRIVATE ROBCOGEN_WITH_${upper})
  endforeach()
  foreach(source IN LISTS sources)
    if(source MATCHES "/batch\\.cpp$")
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS ${omitted_levels})
    endif()
  endforeach()
  _robcogen_has_levels(has_levels)
  if(NOT has_levels)
    return()
  endif()
  # By default, clang fuses products and sums within one expression only, and not through the operators of a class. Square
  # roots of lanes are inlined only if they do not report errors.
  set(batch "(batch/[a-z_]+|united/batch_[0-9]+)")
  set(all -fno-math-errno $<$<CXX_COMPILER_ID:Clang>:-ffp-contract=fast>)
  foreach(source IN LISTS sources)
    if(source MATCHES "/${batch}_baseline\\.cpp$")
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS ${all})
    elseif(source MATCHES "/(kernels|${batch})_(avx2|avx512)(_[12])?\\.cpp$")
      _robcogen_level_options(${CMAKE_MATCH_3} options)
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS ${options} ${all})
    endif()
    # gcc orders the instructions of the highest level's kernels by latency, as long as registers suffice: 4 % faster on
    # average. Bodies over many states would take up to a half longer, because registers do not suffice for them.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU"
       AND (source MATCHES "/kernels_(avx2|avx512)_[12]\\.cpp$" OR (NOT library_levels AND NOT source MATCHES "/(batch|${batch}_[a-z0-9]+)\\.cpp$")))
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS -fschedule-insns -fsched-pressure -fschedule-insns2)
    endif()
  endforeach()
endfunction()
