# robcogen_add_robot(TARGET hyl): CASADI needs the library in C: LANGUAGES must include c
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl CASADI)
