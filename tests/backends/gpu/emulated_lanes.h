// Contexts of one thread of the host in place of the neighbouring threads of a warp: included before the text for GPUs,
// with ROBCOGEN_GPU_EMULATES_LANES. They run one after the other, from each exchange of numbers to the next.
#pragma once

#include <ucontext.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

namespace robcogen::gpu {

class Emulation {
 public:
  Emulation(unsigned lanes, std::function<void()> call) : call_(std::move(call)), lanes_(lanes) {}

  void run() {
    running = this;
    for (Lane& lane : lanes_) {
      getcontext(&lane.context);
      lane.context.uc_stack.ss_sp = lane.stack.data();
      lane.context.uc_stack.ss_size = lane.stack.size();
      lane.context.uc_link = &outside_;
      makecontext(&lane.context, start, 0);
    }
    for (bool is_done = false; !is_done;)
      for (own_ = 0; own_ < lanes_.size(); ++own_) {
        swapcontext(&outside_, &lanes_[own_].context);
        is_done = lanes_[own_].is_done;
        if (lanes_[own_].exchanges != lanes_[0].exchanges || is_done != lanes_[0].is_done) fail();
      }
  }

  int own() const { return static_cast<int>(own_); }

  double exchanged(double x, int from) {
    Lane& lane = lanes_[own_];
    const int round = ++lane.exchanges % 2;  // so that no lane overwrites what another one has not read
    lane.numbers[round] = x;
    swapcontext(&lane.context, &outside_);
    return lanes_[static_cast<std::size_t>(from)].numbers[round];
  }

  static inline Emulation* running = nullptr;

 private:
  struct Lane {
    ucontext_t context = {};
    std::vector<char> stack = std::vector<char>(1 << 20);
    double numbers[2] = {};
    int exchanges = 0;
    bool is_done = false;
  };

  static void start() {
    running->call_();
    running->lanes_[running->own_].is_done = true;
  }
  [[noreturn]] static void fail() {
    std::fputs("threads that share a state exchange numbers at different places\n", stderr);
    std::abort();
  }

  std::function<void()> call_;
  std::vector<Lane> lanes_;
  std::size_t own_ = 0;
  ucontext_t outside_ = {};
};

inline int lane() {
  return Emulation::running->own();
}

template <int kSize, class Number>
Number exchanged(Number x, int other) {
  const int from = (lane() & ~(kSize - 1)) + (other & (kSize - 1));
  return static_cast<Number>(Emulation::running->exchanged(static_cast<double>(x), from));
}

inline void wait_for_lanes() {
  Emulation::running->exchanged(0, lane());
}

// Calls the function once in each lane.
inline void emulate(unsigned lanes, std::function<void()> call) {
  Emulation(lanes, std::move(call)).run();
}

}  // namespace robcogen::gpu
