# robcogen_add_robot(TARGET hyl): TEST_SAMPLES must be positive, not '0'
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl TEST_SAMPLES 0)
