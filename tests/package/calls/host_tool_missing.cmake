# ROBCOGEN_HOST_TOOL must be the absolute path of a robcogen executable; it is '@DIR@/robcogen'
set(ROBCOGEN_HOST_TOOL ${CMAKE_CURRENT_SOURCE_DIR}/robcogen)
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)
