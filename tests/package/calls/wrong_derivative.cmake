# robcogen_add_robot(TARGET hyl): DERIVATIVES: 'inverse_dynamics' is not function:input or function:input,input, such as inverse_dynamics:q,qd
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl DERIVATIVES jacobians.base_J_foot:q inverse_dynamics)
