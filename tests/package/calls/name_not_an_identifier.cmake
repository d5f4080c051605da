# robcogen_add_robot(TARGET hyl): NAME '3-legs' is not an identifier
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAME 3-legs)
