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
