# robcogen_add_robot(TARGET hyl): MODEL needs xacro, which is not on the PATH: @DIR@/hyl.urdf.xacro.
# Install it (ROS: ros-<distribution>-xacro, and source its setup.bash) or set ROBCOGEN_XACRO to its path
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/hyl.urdf.xacro "")
set(CMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH OFF)
set(CMAKE_FIND_USE_CMAKE_SYSTEM_PATH OFF)
robcogen_add_robot(TARGET hyl MODEL hyl.urdf.xacro)
