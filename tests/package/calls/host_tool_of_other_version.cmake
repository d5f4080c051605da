# '@DIR@/robcogen' reports version 0.4.2
set(ROBCOGEN_HOST_TOOL ${CMAKE_CURRENT_SOURCE_DIR}/robcogen)
file(WRITE ${ROBCOGEN_HOST_TOOL} "#!/bin/sh\necho robcogen 0.4.2\n")
file(CHMOD ${ROBCOGEN_HOST_TOOL} PERMISSIONS OWNER_READ OWNER_EXECUTE)
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)
