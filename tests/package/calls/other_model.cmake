# robcogen_add_robot(TARGET hyl): MODEL must be a .kindsl document, a .urdf, an .xml (URDF or MJCF) or a .urdf.xacro, not '.sdf': @DIR@/hyl.sdf
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/hyl.sdf "")
robcogen_add_robot(TARGET hyl MODEL hyl.sdf)
