// Threads of the host in place of the neighbouring threads of a warp: included before the text for GPUs, with
// ROBCOGEN_GPU_EMULATES_LANES. Each exchange of numbers waits for all of them, so a thread that leaves one out stops
// the program instead of reading an old number.
#pragma once

#include <barrier>
#include <thread>
#include <vector>

namespace robcogen::gpu {

struct EmulatedThread {
  int own;
  double* numbers;  // of all threads
  std::barrier<>* all;
};
inline thread_local EmulatedThread emulated = {0, nullptr, nullptr};

inline int lane() {
  return emulated.own;
}

template <int kSize, class Number>
Number exchanged(Number x, int other) {
  emulated.numbers[emulated.own] = static_cast<double>(x);
  emulated.all->arrive_and_wait();
  const auto result = static_cast<Number>(emulated.numbers[(emulated.own & ~(kSize - 1)) + (other & (kSize - 1))]);
  emulated.all->arrive_and_wait();
  return result;
}

// Calls the function in so many threads.
template <class Call>
void emulate(unsigned lanes, const Call& call) {
  std::vector<double> numbers(lanes);
  std::barrier<> all(static_cast<std::ptrdiff_t>(lanes));
  std::vector<std::thread> threads;
  for (unsigned own = 0; own < lanes; ++own)
    threads.emplace_back([&, own] {
      emulated = {static_cast<int>(own), numbers.data(), &all};
      call();
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace robcogen::gpu
