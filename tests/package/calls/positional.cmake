# robcogen_add_robot(): unknown argument 'hyl'; the keywords are
robcogen_add_robot(hyl MODEL hyl.kindsl)
