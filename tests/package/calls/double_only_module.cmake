# robcogen_add_robot(TARGET hyl): PYTHON and DOUBLE_ONLY exclude each other: Python modules also take arrays in single precision
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl PYTHON DOUBLE_ONLY)
