# robcogen_add_robot(TARGET arm): FRICTION_VELOCITY needs PASSIVE_FORCES: without them, friction is not part of the dynamics
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/arm.urdf "")
robcogen_add_robot(TARGET arm MODEL arm.urdf FRICTION_VELOCITY 0.01)
