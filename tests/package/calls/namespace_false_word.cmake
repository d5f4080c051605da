# robcogen_add_robot(TARGET leg): NAME 'N::hyl' is taken by target 'left': give this one another NAMESPACE or NAME
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_N::hyl left)
robcogen_add_robot(TARGET leg MODEL hyl.kindsl NAME hyl NAMESPACE N)
