# robcogen_add_robot(TARGET hyl): MODEL must be a .kindsl document, not '.urdf': @DIR@/hyl.urdf
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/hyl.urdf "")
robcogen_add_robot(TARGET hyl MODEL hyl.urdf)
