# robcogen_add_robot(TARGET hyl): FLOATING_BASE is for URDF; a robot document states this itself: @DIR@/hyl.kindsl
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl FLOATING_BASE)
