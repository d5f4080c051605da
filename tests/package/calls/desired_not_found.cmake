# robcogen_add_robot(TARGET hyl): DESIRED does not exist: @DIR@/list-NOTFOUND
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DESIRED list-NOTFOUND)
