# robcogen_add_robot(TARGET hyl): ALGORITHMS: 'inverse_dynamic' is not one of inverse_dynamics bias_forces passive_forces forward_dynamics joint_space_inertia joint_space_inertia_factor coriolis_matrix centroidal energy transforms jacobians jacobian_references jacobian_derivatives velocities accelerations all
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl ALGORITHMS jacobians inverse_dynamic)
