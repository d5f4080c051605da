# robcogen_add_robot(TARGET hyl): NAME 'union' is a reserved word of the generated code
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl NAME union)
