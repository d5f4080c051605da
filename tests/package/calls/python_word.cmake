# robcogen_add_robot(TARGET hyl): NAME 'lambda' is a word of Python: no module can have it; give another NAME
robcogen_add_robot(TARGET hyl NAME lambda MODEL hyl.kindsl PYTHON)
