// The hook detects allocation in all its forms, and nothing else.
#include "allocation_hook.h"

#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <string>
#include <vector>

namespace robcogen::test {
namespace {

// A value that an optimiser must treat as used.
void* volatile escaped = nullptr;

template <class Call>
void guarded(const Call& call) {
  const NoAllocation during("the loop");
  call();
}

TEST(AllocationHookDeathTest, SeesEveryForm) {
  const auto expect_abort = [](const auto& call, const char* message) { EXPECT_DEATH(guarded(call), message); };
  struct alignas(64) Wide {
    double values[8];
  };
  expect_abort([] { escaped = new int; }, "the loop calls operator new");
  expect_abort([] { escaped = new int[3]; }, "the loop calls operator new");
  expect_abort([] { escaped = new (std::nothrow) int; }, "the loop calls operator new");
  expect_abort([] { escaped = new Wide; }, "the loop calls operator new");
  expect_abort([] { escaped = std::vector<int>(10).data(); }, "the loop calls operator new");
  int* const made = new int;
  escaped = made;  // or the optimiser removes pairs of new and delete
  expect_abort([made] { delete made; }, "the loop calls operator delete");
  delete made;
#ifdef ROBCOGEN_WRAPS_MALLOC
  expect_abort([] { escaped = std::malloc(8); }, "the loop calls malloc");
  expect_abort([] { escaped = std::calloc(1, 8); }, "the loop calls calloc");
  void* const block = std::malloc(8);
  escaped = block;
  expect_abort([block] { escaped = std::realloc(block, 16); }, "the loop calls realloc");
  expect_abort([block] { std::free(block); }, "the loop calls free");
  std::free(block);
#endif
}

TEST(AllocationHook, LetsTheRestPass) {
  std::vector<double> numbers(10);
  {
    const NoAllocation during("the loop");
    for (double& x : numbers) x += 1;
    delete static_cast<int*>(nullptr);
  }
  numbers.push_back(1);  // the guard has ended
  EXPECT_EQ(numbers.size(), 11U);
}

}  // namespace
}  // namespace robcogen::test
