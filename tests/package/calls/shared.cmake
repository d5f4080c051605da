# robcogen_add_robot(TARGET hyl): SHARED is refused: a robot is a static library
robcogen_add_robot(TARGET hyl SHARED MODEL hyl.kindsl)
