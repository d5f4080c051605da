# robcogen_add_robot(TARGET hyl): LANGUAGES does not know 'matlab'; it knows cpp
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES cpp matlab)
