# robcogen_add_robot(TARGET hyl): PROCESSORS: 'avx' is not one of baseline avx2 avx512
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl PROCESSORS avx)
