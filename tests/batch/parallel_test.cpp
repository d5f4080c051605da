// Functions over many states on several threads give the bits of one call, and compute each state once. The thread
// sanitizer checks this, if the compiler has it.
#include "robcogen/parallel.h"

#include <gtest/gtest.h>
#include <parallel_leg/batch.h>
#include <parallel_leg/parallel_leg.h>

#include <atomic>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

namespace robcogen::batch {
namespace {

constexpr int kDof = parallel_leg::kDof;
constexpr double kUntouched = -12345.5;

std::vector<double> random_numbers(std::ptrdiff_t count) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> unit(-2, 2);
  std::vector<double> numbers(static_cast<std::size_t>(count));
  for (double& x : numbers) x = unit(generator);
  return numbers;
}

// Calls the tasks in reverse order on one thread, and records the number of blocks.
struct Backwards {
  template <class Task>
  void operator()(std::ptrdiff_t count, const Task& task) {
    blocks = count;
    for (std::ptrdiff_t i = count - 1; i >= 0; --i) task(i);
  }
  std::ptrdiff_t blocks = 0;
};

constexpr auto kInverseDynamics = [](const auto&... a) { parallel_leg::batch::inverse_dynamics(a...); };
constexpr auto kInertia = [](const auto&... a) { parallel_leg::batch::joint_space_inertia(a...); };

// Sizes around those of blocks: 1,365 states of 192 bytes fit, which is rounded down to 21 times 64.
const std::ptrdiff_t kSizes[] = {0, 1, 63, 64, 65, 1344, 1345, 5000};

class Parallel : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1U, 2U, 5U));

TEST_P(Parallel, IsOneCallByElement) {
  ThreadPool pool(GetParam());
  for (const std::ptrdiff_t n : kSizes) {
    const std::ptrdiff_t stride = n + 3;
    const std::vector<double> q = random_numbers(kDof * stride), qd = random_numbers(kDof * stride);
    const Gravity moon(0, 0, -1.62);
    std::vector<double> expected(static_cast<std::size_t>(kDof * stride), kUntouched), found = expected;
    const auto in = [&](const std::vector<double>& x) { return by_element(x.data(), stride); };
    kInverseDynamics(n, in(q), in(qd), in(q), moon, by_element(expected.data(), stride));
    parallel(pool, n, kInverseDynamics, in(q), in(qd), in(q), moon, by_element(found.data(), stride));
    EXPECT_EQ(found, expected) << n;
  }
}

TEST_P(Parallel, IsOneCallByState) {
  constexpr int kElements = kDof * kDof, kStride = kElements + 2;
  ThreadPool pool(GetParam());
  for (const std::ptrdiff_t n : kSizes) {
    const std::vector<double> q = random_numbers(kDof * n + 1);
    std::vector<double> expected(static_cast<std::size_t>(n * kStride + 1), kUntouched), found = expected;
    kInertia(n, by_state(q.data()), by_state(expected.data(), kStride));
    parallel(pool, n, kInertia, by_state(q.data()), by_state(found.data(), kStride));
    EXPECT_EQ(found, expected) << n;

    std::vector<parallel_leg::InertiaMatrix> matrices(static_cast<std::size_t>(n));
    parallel(pool, n, kInertia, by_state(q.data()), by_state(matrices.data()));
    for (std::size_t i = 0; i < matrices.size(); ++i)
      ASSERT_TRUE(std::equal(matrices[i].data(), matrices[i].data() + kElements, &expected[i * kStride])) << i;
  }
}

// A task may call several functions, whose results meet in one block.
TEST_P(Parallel, CallsSeveralFunctionsInTurn) {
  ThreadPool pool(GetParam());
  constexpr std::ptrdiff_t kCount = 3000;
  const std::vector<double> numbers = random_numbers(kDof * kCount), zeros(numbers.size());
  std::vector<double> forces(numbers.size()), expected(numbers.size()), found(numbers.size());
  const auto twice = [](std::ptrdiff_t n, const auto& q, const auto& zero, const auto& tau, const auto& result) {
    parallel_leg::batch::inverse_dynamics(n, q, zero, zero, tau);
    parallel_leg::batch::inverse_dynamics(n, q, zero, tau, result);
  };
  const auto q = by_state(numbers.data()), zero = by_state(zeros.data());
  parallel_leg::batch::inverse_dynamics(kCount, q, zero, zero, by_element(forces.data(), kCount));
  const std::vector<double> once = forces;
  parallel_leg::batch::inverse_dynamics(kCount, q, zero, by_element(once.data(), kCount), by_state(expected.data()));
  parallel(pool, kCount, twice, q, zero, by_element(forces.data(), kCount), by_state(found.data()));
  EXPECT_EQ(found, expected);
}

// Blocks can be divided into blocks. The outer ones have 4,096 states, because nothing tells them how large a state is.
TEST(Blocks, MayBeDividedAgain) {
  constexpr std::ptrdiff_t kCount = 5000;
  const std::vector<double> q = random_numbers(kDof * kCount);
  std::vector<double> expected(kDof * q.size()), found = expected;
  kInertia(kCount, by_state(q.data()), by_state(expected.data()));
  Backwards outer, inner;
  const auto again = [&](std::ptrdiff_t n, const auto&... a) { parallel(inner, n, kInertia, a...); };
  parallel(outer, kCount, again, by_state(q.data()), by_state(found.data()));
  EXPECT_EQ(found, expected);
  EXPECT_EQ(outer.blocks, 2);
}

TEST(Blocks, CoverAllStatesOnceAndFitTheCache) {
  for (const std::ptrdiff_t n : kSizes) {
    const std::vector<double> q = random_numbers(kDof * n + 1);
    std::vector<double> H(static_cast<std::size_t>(kDof * kDof * n + 1));
    std::ptrdiff_t sum = 0, longest = 0;
    Backwards threads;
    parallel(
        threads, n,
        [&](std::ptrdiff_t count, const auto& at, const auto& to) {
          parallel_leg::batch::joint_space_inertia(count, at, to);
          sum += count;
          longest = std::max(longest, count);
        },
        by_state(q.data()), by_state(H.data()));
    EXPECT_EQ(sum, n);
    constexpr std::ptrdiff_t kBytes = sizeof(parallel_leg::JointState) + sizeof(parallel_leg::InertiaMatrix);
    EXPECT_LE(longest * kBytes, kBlockBytes);
    EXPECT_EQ(threads.blocks, longest == 0 ? 0 : (n + longest - 1) / longest);
    if (threads.blocks > 1) {
      EXPECT_EQ(longest % 64, 0);
      EXPECT_GT((longest + 64) * kBytes, kBlockBytes) << "a longer block fits as well";
    }
  }
}

class Pool : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Threads, Pool, testing::Values(0U, 1U, 2U, 5U));

TEST_P(Pool, CallsEachTaskOnce) {
  ThreadPool pool(GetParam());
  EXPECT_EQ(pool.threads(), std::max(1U, GetParam()));
  for (const std::ptrdiff_t count : {0, 1, 2, 3, 1000}) {
    for (int round = 0; round < 100; ++round) {
      std::vector<int> calls(static_cast<std::size_t>(count));  // plain numbers, because each is written by one thread
      pool(count, [&](std::ptrdiff_t i) { ++calls[static_cast<std::size_t>(i)]; });
      ASSERT_EQ(calls, std::vector<int>(calls.size(), 1));
    }
  }
}

TEST(Pool, SharesTheCalls) {
  ThreadPool pool(2);
  std::mutex mutex;
  std::vector<std::thread::id> callers;
  std::atomic<int> waiting = 0;
  pool(2, [&](std::ptrdiff_t) {  // neither ends before both have begun
    ++waiting;
    while (waiting < 2) std::this_thread::yield();
    const std::lock_guard lock(mutex);
    callers.push_back(std::this_thread::get_id());
  });
  ASSERT_EQ(callers.size(), 2U);
  EXPECT_NE(callers[0], callers[1]);
}

TEST(Pool, IsFreeForCallsWithinATask) {
  ThreadPool pool(3);
  std::atomic<int> calls = 0;
  pool(4, [&](std::ptrdiff_t) { pool(5, [&](std::ptrdiff_t) { ++calls; }); });
  EXPECT_EQ(calls, 20);
}

TEST(Pool, ServesSeveralThreads) {
  ThreadPool pool(3);
  std::atomic<int> calls = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int round = 0; round < 200; ++round) pool(7, [&](std::ptrdiff_t) { ++calls; });
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(calls, 4 * 200 * 7);
}

}  // namespace
}  // namespace robcogen::batch
