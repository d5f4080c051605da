#include "allocation_hook.h"

#include <cstdio>
#include <cstdlib>
#include <new>

#ifdef _WIN32
#include <malloc.h>
#endif

namespace {

thread_local const char* forbidden_in = nullptr;

void refuse(const char* function) noexcept {
  if (forbidden_in == nullptr) return;
  const char* what = forbidden_in;
  forbidden_in = nullptr;  // the message may allocate
  std::fprintf(stderr, "%s calls %s\n", what, function);
  std::abort();
}

// If memory runs out, the program ends: that case is not tested here.
void* allocated(void* memory) noexcept {
  if (memory == nullptr) std::abort();
  return memory;
}

// Windows has functions of its own, whose memory std::free does not release.
#ifdef _WIN32
void* aligned(std::size_t size, std::align_val_t alignment) noexcept {
  return allocated(_aligned_malloc(size, static_cast<std::size_t>(alignment)));
}
void free_aligned(void* memory) noexcept {
  _aligned_free(memory);
}
#else
void* aligned(std::size_t size, std::align_val_t alignment) noexcept {
  const std::size_t to = static_cast<std::size_t>(alignment);
  return allocated(std::aligned_alloc(to, (size + to - 1) / to * to));
}
void free_aligned(void* memory) noexcept {
  std::free(memory);
}
#endif

}  // namespace

namespace robcogen {

NoAllocation::NoAllocation(const char* what) noexcept {
  forbidden_in = what;
}
NoAllocation::~NoAllocation() {
  forbidden_in = nullptr;
}

}  // namespace robcogen

// Replaces everything that the standard allows a program to replace, so that allocation and release always match.
void* operator new(std::size_t size) {
  refuse("operator new");
  return allocated(std::malloc(size == 0 ? 1 : size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  refuse("operator new");
  return aligned(size, alignment);
}
void* operator new[](std::size_t size) {
  return operator new(size);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return operator new(size, alignment);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return operator new(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return operator new(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return operator new(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return operator new(size, alignment);
}

void operator delete(void* memory) noexcept {
  if (memory != nullptr) refuse("operator delete");
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  operator delete(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  operator delete(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  if (memory != nullptr) refuse("operator delete");
  free_aligned(memory);
}
void operator delete[](void* memory, std::align_val_t alignment) noexcept {
  operator delete(memory, alignment);
}
void operator delete(void* memory, std::size_t, std::align_val_t alignment) noexcept {
  operator delete(memory, alignment);
}
void operator delete[](void* memory, std::size_t, std::align_val_t alignment) noexcept {
  operator delete(memory, alignment);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  operator delete(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
  operator delete(memory);
}
void operator delete(void* memory, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  operator delete(memory, alignment);
}
void operator delete[](void* memory, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  operator delete(memory, alignment);
}

#ifdef ROBCOGEN_WRAPS_MALLOC
extern "C" {
// The linker redirects calls of malloc to __wrap_malloc, and calls of __real_malloc to malloc.
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);
void __real_free(void* memory);
void* __wrap_malloc(std::size_t size);
void* __wrap_calloc(std::size_t count, std::size_t size);
void* __wrap_realloc(void* memory, std::size_t size);
void __wrap_free(void* memory);

void* __wrap_malloc(std::size_t size) {
  refuse("malloc");
  return __real_malloc(size);
}
void* __wrap_calloc(std::size_t count, std::size_t size) {
  refuse("calloc");
  return __real_calloc(count, size);
}
void* __wrap_realloc(void* memory, std::size_t size) {
  refuse("realloc");
  return __real_realloc(memory, size);
}
void __wrap_free(void* memory) {
  if (memory != nullptr) refuse("free");
  __real_free(memory);
}
}
#endif
