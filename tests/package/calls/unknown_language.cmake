# robcogen_add_robot(TARGET hyl): LANGUAGES does not know 'fortran'; it knows cpp matlab maxima
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES cpp fortran)
