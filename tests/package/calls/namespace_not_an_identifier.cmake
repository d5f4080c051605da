# robcogen_add_robot(TARGET hyl): NAMESPACE 'b.c' is not an identifier
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAMESPACE a::b.c)
