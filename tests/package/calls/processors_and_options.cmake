# robcogen_add_robot(TARGET hyl): PROCESSORS, and COMPILE_OPTIONS that choose a processor or no optimisation, exclude each other
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl PROCESSORS avx2 COMPILE_OPTIONS -march=native)
