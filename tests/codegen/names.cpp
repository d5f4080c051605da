// What system headers keep to themselves, and then a robot and transforms of such names.
#include <assert.h>
#include <complex.h>
#include <errno.h>
#include <getopt.h>
#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/types.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "names/batch.h"
#include "names/bias_forces.cpp"
#include "names/centroidal.cpp"
#include "names/energy.cpp"
#include "names/forward_dynamics.cpp"
#include "names/inverse_dynamics.cpp"
#include "names/jacobians.cpp"
#include "names/joint_space_inertia.cpp"
#include "names/joint_space_inertia_factor.cpp"
#include "names/names.h"
#include "names/parameters.cpp"
#include "names/reflection.h"
#include "names/transforms.cpp"
#include "names/trigonometry.cpp"
#include "sincos/reflection.h"
#include "sincos/sincos.h"
#include "sincos/transforms.cpp"

int main() {}
