# This package has variables instead of a target.
set(inverse_dynamics_solver_INCLUDE_DIRS ${CMAKE_CURRENT_LIST_DIR}/../../../include)
