# robcogen_add_robot(TARGET hyl): missing value: ALGORITHMS and DESIRED
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DESIRED ALGORITHMS)
