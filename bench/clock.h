// Cycles of the processor as a unit of time, to find its frequency while the functions are measured.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>

namespace robcogen::bench {

// Adds the benchmark `clock/1024`: 1024 additions of registers, each of which waits for the previous one. Current
// processors take one cycle for each.
inline void add_clock() {
#ifdef __GNUC__
  benchmark::RegisterBenchmark("clock/1024", [](benchmark::State& state) {
    std::uint64_t sum = 0, term = static_cast<std::uint64_t>(state.max_iterations);
    // The asm statement keeps the compiler from combining additions.
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
