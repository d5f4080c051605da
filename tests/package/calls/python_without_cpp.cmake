# robcogen_add_robot(TARGET hyl): PYTHON makes a module of the library in C++: LANGUAGES must have cpp
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES matlab PYTHON)
