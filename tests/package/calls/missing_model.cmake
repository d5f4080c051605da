# robcogen_add_robot(TARGET hyl): MODEL does not exist: @DIR@/hly.kindsl (name its rule in DEPENDS if the build generates it)
robcogen_add_robot(TARGET hyl MODEL hly.kindsl)
