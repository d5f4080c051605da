# robcogen_add_robot(TARGET hyl): SHARED is not supported: generated code is a static library
robcogen_add_robot(TARGET hyl SHARED MODEL hyl.kindsl)
