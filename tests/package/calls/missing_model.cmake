# robcogen_add_robot(TARGET hyl): MODEL does not exist: @DIR@/hly.kindsl (DEPENDS, when a rule of the build makes it)
robcogen_add_robot(TARGET hyl MODEL hly.kindsl)
