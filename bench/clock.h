// Cycles of the processor as a unit of time, for the frequency that it has while the functions are measured.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>

namespace robcogen::bench {

// Adds `clock/1024`: so many additions of registers, each of which waits for the one before. Present processors take
// one cycle for each.
inline void add_clock() {
#ifdef __GNUC__
  benchmark::RegisterBenchmark("clock/1024", [](benchmark::State& state) {
    std::uint64_t sum = 0, term = static_cast<std::uint64_t>(state.max_iterations);
    // Keeps the compiler from adding faster than that.
    const auto add = [&] {
      sum += term;
      asm volatile("" : "+r"(sum), "+r"(term));
    };
    for (auto _ : state) {
      for (int i = 0; i < 1024; i += 16) {
        add(), add(), add(), add(), add(), add(), add(), add();
        add(), add(), add(), add(), add(), add(), add(), add();
      }
    }
    benchmark::DoNotOptimize(sum);
  });
#endif
}

}  // namespace robcogen::bench
