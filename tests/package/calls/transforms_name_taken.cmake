# robcogen_add_transforms(TARGET other): NAME 'euler' is taken by target 'euler'
set_property(GLOBAL PROPERTY ROBCOGEN_OWNER_OF_euler euler)
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/euler.motdsl "")
robcogen_add_transforms(TARGET other NAME euler MOTIONS euler.motdsl)
