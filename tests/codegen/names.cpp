// Names that system headers reserve, followed by a robot and transforms with such names.
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

#include "linux/index/names/batch.h"
#include "linux/index/names/bias_forces.cpp"
#include "linux/index/names/centroidal.cpp"
#include "linux/index/names/energy.cpp"
#include "linux/index/names/forward_dynamics.cpp"
#include "linux/index/names/inverse_dynamics.cpp"
#include "linux/index/names/jacobians.cpp"
#include "linux/index/names/joint_space_inertia.cpp"
#include "linux/index/names/joint_space_inertia_factor.cpp"
#include "linux/index/names/names.h"
#include "linux/index/names/parameters.cpp"
#include "linux/index/names/reflection.h"
#include "linux/index/names/transforms.cpp"
#include "linux/index/names/trigonometry.cpp"
#include "linux/index/sincos/reflection.h"
#include "linux/index/sincos/sincos.h"
#include "linux/index/sincos/transforms.cpp"

int main() {}
