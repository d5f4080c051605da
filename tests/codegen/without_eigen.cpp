// Generated code that compiles without Eigen: constants, tables, kernels and the units that instantiate them. Headers
// that users may include, too, come first, because they define macros.
#include <complex.h>
#include <math.h>
#include <sys/sysmacros.h>

#include "cart_pole/bias_forces.cpp"
#include "cart_pole/forward_dynamics.cpp"
#include "cart_pole/inverse_dynamics.cpp"
#include "cart_pole/jacobians.cpp"
#include "cart_pole/joint_space_inertia.cpp"
#include "cart_pole/joint_space_inertia_factor.cpp"
#include "cart_pole/model.h"
#include "cart_pole/reflection.h"
#include "cart_pole/transforms.cpp"
#include "legs/floating/hopper/bias_forces.cpp"
#include "legs/floating/hopper/forward_dynamics.cpp"
#include "legs/floating/hopper/inverse_dynamics.cpp"
#include "legs/floating/hopper/joint_space_inertia.cpp"
#include "legs/floating/hopper/model.h"
#include "legs/floating/hopper/reflection.h"
#include "literals/literals.cpp"
#include "literals/model.h"
#include "literals/reflection.h"
#include "my/robcogen/class/robot/inverse_dynamics.cpp"
#include "my/robcogen/class/robot/jacobians.cpp"
#include "my/robcogen/class/robot/model.h"
#include "my/robcogen/class/robot/reflection.h"
#include "my/robcogen/class/robot/transforms.cpp"
#include "plinth/bias_forces.cpp"
#include "plinth/forward_dynamics.cpp"
#include "plinth/inverse_dynamics.cpp"
#include "plinth/joint_space_inertia.cpp"
#include "plinth/joint_space_inertia_factor.cpp"
#include "plinth/model.h"
#include "plinth/reflection.h"

int main() {}
