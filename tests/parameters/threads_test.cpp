// Threads: any number of them can read one object; new values are put into a copy, and the copy is handed on.
#include <everywhere_fixed/everywhere_fixed.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "values.h"

namespace robcogen::test::threads_test {
namespace {

using namespace everywhere_fixed;

constexpr int kThreads = 4, kCalls = 2000;
const JointState kQ(0.3, -0.7, 0.2, 1.1), kQd(1.0, -0.4, 0.3, 2.0), kQdd(0.5, 1.5, -2.0, 0.7);

JointState tau_of(const Parameters<>& parameters) {
  return inverse_dynamics(parameters, kQ, kQd, kQdd);
}

void run_all(const std::vector<std::function<void()>>& bodies) {
  std::vector<std::thread> threads;
  for (const auto& body : bodies) threads.emplace_back(body);
  for (std::thread& thread : threads) thread.join();
}

TEST(Threads, ManyReadOneObject) {
  const Parameters<> parameters;
  const JointState expected = tau_of(parameters);
  std::atomic<int> wrong = 0;
  run_all(std::vector<std::function<void()>>(kThreads, [&] {
    for (int i = 0; i < kCalls; ++i) wrong += tau_of(parameters) == expected ? 0 : 1;
  }));
  EXPECT_EQ(wrong, 0);
}

// One thread changes values; the others keep using those that they have until they fetch them again. No thread ever
// sees a mixture.
TEST(Threads, AnUpdatedCopyIsHandedOn) {
  const ParameterValues one, other = other_values<ParameterValues>();
  const JointState tau_one = tau_of(Parameters<>(one)), tau_other = tau_of(Parameters<>(other));
  ASSERT_NE(tau_one, tau_other);

  std::mutex mutex;  // guards the pointer, not its target
  auto current = std::make_shared<const Parameters<>>(one);
  const auto get = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return current;
  };

  std::atomic<int> mixtures = 0;
  std::vector<std::function<void()>> bodies(kThreads, [&] {
    for (int i = 0; i < kCalls; ++i) {
      const JointState tau = tau_of(*get());
      mixtures += tau == tau_one || tau == tau_other ? 0 : 1;
    }
  });
  bodies.push_back([&] {
    for (int i = 0; i < kCalls; ++i) {
      auto next = std::make_shared<Parameters<>>(*get());
      next->update(i % 2 == 0 ? other : one);
      const std::lock_guard<std::mutex> lock(mutex);
      current = std::move(next);
    }
  });
  run_all(bodies);
  EXPECT_EQ(mixtures, 0);
}

}  // namespace
}  // namespace robcogen::test::threads_test
