# robcogen_add_robot(TARGET leg): NAME 'hyl' is taken by target 'hyl'
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_hyl hyl)
robcogen_add_robot(TARGET leg MODEL hyl.kindsl NAME hyl)
