# robcogen_add_robot(TARGET hyl): MODEL must be a .kindsl document or a .urdf, not '.xacro': @DIR@/hyl.xacro
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/hyl.xacro "")
robcogen_add_robot(TARGET hyl MODEL hyl.xacro)
