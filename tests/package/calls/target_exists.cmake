# robcogen_add_robot(TARGET hyl): a target with this name already exists
add_custom_target(hyl)
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl)
