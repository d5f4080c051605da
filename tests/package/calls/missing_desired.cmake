# robcogen_add_robot(TARGET hyl): DESIRED does not exist: @DIR@/hyl.dtdsl
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DESIRED hyl.dtdsl)
