// Ends the program when code that must not allocate does.
#pragma once

namespace robcogen {

// While one lives, every allocation and every release of memory in this thread writes a message that names `what` and
// aborts. Seen are operator new and delete everywhere, and malloc, calloc, realloc and free in all that is linked
// statically, where the linker can wrap symbols (see tests/real_time/CMakeLists.txt).
class NoAllocation {
 public:
  explicit NoAllocation(const char* what) noexcept;
  ~NoAllocation();
  NoAllocation(const NoAllocation&) = delete;
  NoAllocation& operator=(const NoAllocation&) = delete;
};

}  // namespace robcogen
