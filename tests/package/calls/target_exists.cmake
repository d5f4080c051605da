# robcogen_add_robot(TARGET hyl): a target of this name exists already
add_custom_target(hyl)
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)
