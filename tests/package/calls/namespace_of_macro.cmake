# robcogen_add_robot(TARGET hyl): NAMESPACE 'linux' is a macro or a function of system headers: give another NAMESPACE
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAMESPACE robots::linux)
