# robcogen_add_robot(TARGET hyl): ROBOT is for MJCF, whose scenes have several robots: @DIR@/hyl.kindsl
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl ROBOT base)
