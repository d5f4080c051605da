#include <cstdlib>

double* allocates() {
  return static_cast<double*>(std::malloc(sizeof(double)));
}
