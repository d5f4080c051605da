# robcogen_add_robot(TARGET hyl): TEST_SAMPLES must be a whole number, not '-5'
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl TEST_SAMPLES -5)
