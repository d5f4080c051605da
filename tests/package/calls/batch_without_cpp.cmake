# robcogen_add_robot(TARGET hyl): BATCH is for C++: LANGUAGES must include cpp
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES matlab BATCH)
