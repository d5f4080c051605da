# robcogen_add_robot(TARGET hyl): FLOATING_BASE is for URDF; a robot document says such things itself: @DIR@/hyl.kindsl
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl FLOATING_BASE)
