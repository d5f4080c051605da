# robcogen_add_transforms(TARGET euler): DERIVATIVES: 'transforms.homogeneous.A_X_B:' is not function:input or function:input,input, such as inverse_dynamics:q,qd
robcogen_add_transforms(TARGET euler MOTIONS euler.motdsl DERIVATIVES transforms.homogeneous.A_X_B:)
