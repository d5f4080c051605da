# robcogen_add_robot(TARGET leg): NAME 'hyl' is taken by target 'hyl': give this one a NAMESPACE or another NAME
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_hyl hyl)
robcogen_add_robot(TARGET leg MODEL hyl.kindsl NAME hyl)
