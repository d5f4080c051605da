# robcogen_add_robot(TARGET hyl): PYTHON and DOUBLE_ONLY exclude each other: modules take arrays in single precision, too
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl PYTHON DOUBLE_ONLY)
