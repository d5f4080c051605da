# robcogen_add_robot(TARGET hyl): NAME 'lambda' is a Python keyword, which cannot name a module: give another NAME
robcogen_add_robot(TARGET hyl NAME lambda MODEL hyl.kindsl PYTHON)
