# robcogen_add_robot(TARGET hyl): NAMESPACE '' is not an identifier
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAMESPACE a::::b)
