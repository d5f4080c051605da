# robcogen_add_robot(TARGET leg): NAME 'left::hyl' is taken by target 'left_leg': give this one another NAMESPACE or NAME
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_hyl hyl)
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_left::hyl left_leg)
robcogen_add_robot(TARGET leg MODEL hyl.kindsl NAME hyl NAMESPACE left)
