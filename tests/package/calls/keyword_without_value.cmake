# robcogen_add_robot(TARGET hyl): ALGORITHMS and DESIRED without a value
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DESIRED ALGORITHMS)
