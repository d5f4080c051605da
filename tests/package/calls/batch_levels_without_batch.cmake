# robcogen_add_robot(TARGET leg): BATCH_LEVELS needs BATCH
robcogen_add_robot(TARGET leg MODEL hyl.kindsl BATCH_LEVELS avx2)
