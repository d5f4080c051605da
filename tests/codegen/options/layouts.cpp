// A function that takes results of the library, and a program that calls it: two files, compiled with different
// options.
#include "robcogen/results.h"

using Motion = robcogen::GeneralizedAcceleration<double, 4>;

double step(const Motion& motion);

#ifdef CALLS
int main() {
  Motion motion;
  motion.qdd.setZero();
  return static_cast<int>(step(motion));
}
#else
double step(const Motion& motion) {
  return motion.qdd.sum() + motion.base_acceleration.linear().sum();
}
#endif
