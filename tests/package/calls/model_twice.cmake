# robcogen_add_robot(TARGET hyl): MODEL is given 2 times; it has one value
robcogen_add_robot(TARGET hyl MODEL hly.kindsl MODEL hyl.kindsl)
