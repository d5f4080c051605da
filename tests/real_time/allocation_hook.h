// Ends the program when code that must not allocate does so.
#pragma once

namespace robcogen {

// While an object lives, every allocation and every release of memory in this thread writes a message that names
// `what`, and aborts. The hook covers operator new and delete everywhere, and malloc, calloc, realloc and free in all
// that is linked statically, if the linker can wrap symbols (see tests/real_time/CMakeLists.txt).
class NoAllocation {
 public:
  explicit NoAllocation(const char* what) noexcept;
  ~NoAllocation();
  NoAllocation(const NoAllocation&) = delete;
  NoAllocation& operator=(const NoAllocation&) = delete;
};

}  // namespace robcogen
