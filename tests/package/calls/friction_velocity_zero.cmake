# robcogen_add_robot(TARGET arm): FRICTION_VELOCITY is a positive number (rad/s, m/s), not '0.0'
file(WRITE ${CMAKE_CURRENT_SOURCE_DIR}/arm.urdf "")
robcogen_add_robot(TARGET arm MODEL arm.urdf PASSIVE_FORCES FRICTION_VELOCITY 0.0)
