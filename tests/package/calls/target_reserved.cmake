# robcogen_add_robot(TARGET double): NAME 'double' is a reserved word of the generated code
robcogen_add_robot(TARGET double MODEL hyl.kindsl)
