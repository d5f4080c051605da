# robcogen_add_robot(TARGET hyl): MODEL is missing
robcogen_add_robot(TARGET hyl)
