# robcogen_add_robot(TARGET hyl): NAME 'sincos' is a macro or a function of system headers: give another NAME
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAME sincos)
