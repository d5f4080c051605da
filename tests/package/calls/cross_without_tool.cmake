# that runs on this machine. Set ROBCOGEN_HOST_TOOL to the path of one; from the source tree,
# ROBCOGEN_BUILD_HOST_TOOL=ON builds it.
unset(ROBCOGEN_HOST_TOOL CACHE)
set(CMAKE_CROSSCOMPILING TRUE)
set(CMAKE_FIND_USE_CMAKE_SYSTEM_PATH OFF)
set(ENV{PATH} "")
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)
