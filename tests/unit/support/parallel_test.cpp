#include "support/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/lazy.h"

namespace robcogen::parallel_test {
namespace {

TEST(ForEachIndex, CallsEachOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
    std::vector<std::atomic<int>> calls(count);
    for_each_index(count, [&](std::size_t i) { ++calls[i]; });
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(calls[i], 1) << i;
  }
}

// The exception of another index may be thrown earlier.
TEST(ForEachIndex, ThrowsWhatTheFirstThrewWhenAllAreDone) {
  std::atomic<int> calls = 0;
  try {
    for_each_index(100, [&](std::size_t i) {
      ++calls;
      if (i == 23 || i == 77) throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "23");
  }
  EXPECT_EQ(calls, 100);
}

TEST(Lazy, IsMadeOnceByTheFirstCaller) {
  Lazy<int> value;
  std::atomic<int> makings = 0;
  std::vector<int> found(100);
  for_each_index(found.size(), [&](std::size_t i) { found[i] = value.get([&] { return 42 + makings++; }); });
  EXPECT_EQ(makings, 1);
  EXPECT_EQ(found, std::vector<int>(found.size(), 42));
  EXPECT_EQ(value.get([] { return 7; }), 42);
}

TEST(Lazy, IsMadeAnewWhenMakingFailed) {
  Lazy<int> value;
  EXPECT_THROW(value.get([]() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(value.get([] { return 7; }), 7);
}

}  // namespace
}  // namespace robcogen::parallel_test
