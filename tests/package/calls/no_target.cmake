# robcogen_add_robot(): TARGET is missing
robcogen_add_robot(MODEL hyl.kindsl)
