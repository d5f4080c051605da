// Code that breaks one rule of real-time code each; a definition chooses which.
#if defined(OFFENDER_ALLOCATES)
#include <cstdlib>

double* allocates() {
  return static_cast<double*>(std::malloc(sizeof(double)));
}

#elif defined(OFFENDER_LARGE_FRAME)
void fill(volatile double* values, int count);

void large_frame() {
  volatile double values[20000];
  fill(values, 20000);
}

void fill(volatile double* values, int count) {
  for (int i = 0; i < count; ++i) values[i] = i;
}

#elif defined(OFFENDER_CHANGING_FRAME)
void fill(volatile char* values, unsigned count);

void changing_frame(unsigned count) {
  fill(static_cast<volatile char*>(__builtin_alloca(count)), count);
}

void fill(volatile char* values, unsigned count) {
  for (unsigned i = 0; i < count; ++i) values[i] = 0;
}

#elif defined(OFFENDER_LARGE_STACK)
// No single frame is large, but the frames of a body over many states, of the kernel that it calls, of the core and of
// a part of the core add up: 25,000 + 24,000 + 10,000 + 23,000 bytes. The other body and the other part do not count,
// because no call contains both.
namespace offender {

#define OFFENDER_FUNCTION(name, bytes)    \
  void name() {                           \
    volatile char values[bytes];          \
    for (auto& value : values) value = 1; \
  }

namespace kernel {
OFFENDER_FUNCTION(f, 24000)

namespace core {
OFFENDER_FUNCTION(f, 10000)

namespace parts {
OFFENDER_FUNCTION(f_1, 23000)
OFFENDER_FUNCTION(f_2, 22000)
}  // namespace parts
}  // namespace core
}  // namespace kernel

namespace batch::body {
OFFENDER_FUNCTION(f, 25000)
OFFENDER_FUNCTION(g, 20000)
}  // namespace batch::body

}  // namespace offender

#else
#error "no offender is chosen"
#endif
