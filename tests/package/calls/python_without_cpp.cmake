# robcogen_add_robot(TARGET hyl): PYTHON needs the library in C++: LANGUAGES must include cpp
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES matlab PYTHON)
