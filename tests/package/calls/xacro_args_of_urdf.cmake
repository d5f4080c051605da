# robcogen_add_robot(TARGET hyl): XACRO_ARGS is for a MODEL that xacro expands, with the extension .urdf.xacro or .xacro: @DIR@/hyl.urdf
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/hyl.urdf "")
robcogen_add_robot(TARGET hyl MODEL hyl.urdf XACRO_ARGS length:=0.7)
