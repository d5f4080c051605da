# robcogen_add_transforms(TARGET crane): the library needs a C++ compiler: write enable_language(CXX), or
# project(… LANGUAGES CXX), before this call
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/crane.motdsl "")
robcogen_add_transforms(TARGET crane MOTIONS crane.motdsl)
