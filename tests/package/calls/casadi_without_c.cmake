# robcogen_add_robot(TARGET hyl): CASADI makes functions of the library in C: LANGUAGES must have c
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl CASADI)
