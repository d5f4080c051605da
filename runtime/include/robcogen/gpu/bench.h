// Checks functions over many states on the device against the same text on the host, and measures their times: included
// by the program bench.cu that a library for GPUs has. Compiled as C++ for the host, it checks and times the host.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "robcogen/gpu/batch.h"
#include "robcogen/gpu/dialect.h"

namespace robcogen::gpu {

// Memory and time of the device.
#if defined(__CUDACC__) || defined(__HIP__)
#if defined(__CUDACC__)
#define ROBCOGEN_GPU_API(name) cuda##name
#else
#define ROBCOGEN_GPU_API(name) hip##name
#endif
inline void require(ROBCOGEN_GPU_API(Error_t) error) {
  if (error == ROBCOGEN_GPU_API(Success)) return;
  std::fprintf(stderr, "%s\n", ROBCOGEN_GPU_API(GetErrorString)(error));
  std::exit(1);
}
inline void* allocated(std::size_t bytes) {
  void* memory = nullptr;
  require(ROBCOGEN_GPU_API(Malloc)(&memory, bytes));
  return memory;
}
inline void release(void* memory) {
  require(ROBCOGEN_GPU_API(Free)(memory));
}
inline void copy(void* to, const void* from, std::size_t bytes) {
  require(ROBCOGEN_GPU_API(Memcpy)(to, from, bytes, ROBCOGEN_GPU_API(MemcpyDefault)));
}
inline std::size_t available() {
  std::size_t free = 0, total = 0;
  require(ROBCOGEN_GPU_API(MemGetInfo)(&free, &total));
  return free;
}
inline void wait() {
  require(ROBCOGEN_GPU_API(DeviceSynchronize)());
}
#undef ROBCOGEN_GPU_API
#else
inline void* allocated(std::size_t bytes) {
  return std::malloc(bytes);
}
inline void release(void* memory) {
  std::free(memory);
}
inline void copy(void* to, const void* from, std::size_t bytes) {
  std::memcpy(to, from, bytes);
}
inline std::size_t available() {
  return std::numeric_limits<std::size_t>::max();
}
inline void wait() {}
#endif

template <class Number>
class DeviceMemory {
 public:
  explicit DeviceMemory(std::size_t count) : count_(count), data_(static_cast<Number*>(allocated(bytes() + 1))) {}
  DeviceMemory(const DeviceMemory&) = delete;
  DeviceMemory& operator=(const DeviceMemory&) = delete;
  ~DeviceMemory() { release(data_); }

  Number* data() const { return data_; }
  std::size_t bytes() const { return count_ * sizeof(Number); }
  void set(const std::vector<Number>& numbers) { copy(data_, numbers.data(), bytes()); }
  std::vector<Number> numbers() const {
    std::vector<Number> result(count_);
    copy(result.data(), data_, bytes());
    return result;
  }

 private:
  std::size_t count_;
  Number* data_;
};

struct BenchArray {
  const char* name;
  std::size_t size;  // elements of one state
  bool is_output;
  const double* fixed = nullptr;  // its values in all states; null: random ones
  bool is_positive = false;       // random ones above a half
};

// A function in one precision.
template <class Number>
struct BenchFunction {
  const char* name;
  std::vector<BenchArray> arrays;
  std::size_t workspace;  // elements of one state
  double rounding;        // error of the function as the generator states it, in units of one operation
  robcogen_gpu_status (*start)(void* stream, std::ptrdiff_t n, const robcogen_gpu_array*, robcogen_gpu_workspace);
  void (*on_host)(const double* const* inputs, double* const* outputs);
};

// Calls a function over many states with its arrays, and with the workspace if it takes one.
template <auto function>
struct StartedBy;
template <class... Arguments, robcogen_gpu_status (*function)(void*, std::ptrdiff_t, Arguments...)>
struct StartedBy<function> {
  static robcogen_gpu_status start(
      void* stream,
      std::ptrdiff_t n,
      const robcogen_gpu_array* next,
      robcogen_gpu_workspace workspace) {
    // Braces evaluate the arguments from left to right.
    return std::apply(
        [&](const auto&... a) { return function(stream, n, a...); },
        std::tuple<Arguments...>{Next<Arguments>::of(next, workspace)...});
  }

 private:
  template <class Argument, class = void>
  struct Next {
    static const robcogen_gpu_array& of(const robcogen_gpu_array*& next, const robcogen_gpu_workspace&) {
      return *next++;
    }
  };
  template <class Unused>
  struct Next<robcogen_gpu_workspace, Unused> {
    static const robcogen_gpu_workspace& of(const robcogen_gpu_array*&, const robcogen_gpu_workspace& workspace) {
      return workspace;
    }
  };
};

// The arrays of a function for n states, all in one layout.
template <class Number>
class BenchStates {
 public:
  BenchStates(const BenchFunction<Number>& f, std::ptrdiff_t n, robcogen_gpu_layout layout, unsigned seed)
      : f_(f), n_(static_cast<std::size_t>(n)), layout_(layout), space_(padded() * f.workspace) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const BenchArray& a : f.arrays) {
      std::vector<Number> values(padded() * a.size);
      given_.push_back(std::move(values));
      for (std::size_t i = 0; i < padded() && !a.is_output; ++i)
        for (std::size_t k = 0; k < a.size; ++k)
          given_.back()[place(given_.size() - 1, k, i)] = static_cast<Number>(
              a.fixed         ? a.fixed[k]
              : a.is_positive ? 1 + unit(engine) / 2
                              : unit(engine));
      memory_.push_back(new DeviceMemory<Number>(given_.back().size()));
      memory_.back()->set(given_.back());
    }
  }
  ~BenchStates() {
    for (DeviceMemory<Number>* m : memory_) delete m;
  }
  BenchStates(const BenchStates&) = delete;
  BenchStates& operator=(const BenchStates&) = delete;

  void run() const {
    std::vector<robcogen_gpu_array> arrays;
    for (const DeviceMemory<Number>* m : memory_)
      arrays.push_back({m->data(), layout_, static_cast<std::ptrdiff_t>(padded())});
    const robcogen_gpu_status status =
        f_.start(nullptr, static_cast<std::ptrdiff_t>(n_), arrays.data(), {space_.data(), space_.bytes()});
    if (status == robcogen_gpu_success) return;
    std::fprintf(stderr, "%s: %s\n", f_.name, robcogen_gpu_message(status));
    std::exit(1);
  }

  // The largest difference from the same text on the host in double precision, as a multiple of the tolerance: eight
  // times the stated rounding error, relative to the largest element of an array in the state, or to a quarter of the
  // root mean square of that over the states. NaN on both sides counts as equal.
  double worst() const {
    double worst = 0;
    const std::vector<std::vector<std::vector<double>>> states = on_host();  // by state, by array
    for (std::size_t a = 0; a < f_.arrays.size(); ++a) {
      if (!f_.arrays[a].is_output) continue;
      const std::vector<Number> computed = memory_[a]->numbers();
      double squares = 0;
      for (const auto& state : states) squares += largest(state[a]) * largest(state[a]);
      const double least = std::sqrt(squares / static_cast<double>(n_)) / 4;
      for (std::size_t i = 0; i < n_; ++i) {
        const double scale = std::fmax(least, largest(states[i][a]));
        const double unit = 8 * std::fmax(4, f_.rounding) * std::numeric_limits<Number>::epsilon() * scale;
        for (std::size_t k = 0; k < f_.arrays[a].size; ++k) {
          const double x = static_cast<double>(computed[place(a, k, i)]), y = states[i][a][k];
          if (x == y || (std::isnan(x) && std::isnan(y))) continue;
          const double difference = std::fabs(x - y);
          if (difference <= worst * unit) continue;
          worst = unit > 0 && std::isfinite(difference) ? difference / unit : HUGE_VAL;
        }
      }
    }
    return worst;
  }

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const BenchArray& a : f_.arrays) sum += n_ * a.size * sizeof(Number);
    return sum;
  }

 private:
  const BenchFunction<Number>& f_;
  std::size_t n_;
  robcogen_gpu_layout layout_;
  std::vector<DeviceMemory<Number>*> memory_ = {};
  std::vector<std::vector<Number>> given_ = {};
  DeviceMemory<Number> space_;

  static double largest(const std::vector<double>& numbers) {
    double result = 0;
    for (const double x : numbers) result = std::fmax(result, std::fabs(x));
    return result;
  }

  std::vector<std::vector<std::vector<double>>> on_host() const {
    std::vector<std::vector<std::vector<double>>> states(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      std::vector<const double*> inputs;
      std::vector<double*> outputs;
      for (std::size_t a = 0; a < f_.arrays.size(); ++a) {
        std::vector<double>& numbers = states[i].emplace_back(f_.arrays[a].size + 1);
        for (std::size_t k = 0; k < f_.arrays[a].size; ++k)
          numbers[k] = f_.arrays[a].is_output ? 0 : static_cast<double>(given_[a][place(a, k, i)]);
        if (f_.arrays[a].is_output)
          outputs.push_back(numbers.data());
        else
          inputs.push_back(numbers.data());
      }
      f_.on_host(inputs.data(), outputs.data());
    }
    return states;
  }

  std::size_t padded() const { return (n_ + 31) / 32 * 32; }
  std::size_t place(std::size_t a, std::size_t k, std::size_t i) const {
    const std::size_t size = f_.arrays[a].size;
    return layout_ == robcogen_gpu_by_tile      ? i / 32 * 32 * size + k * 32 + i % 32
           : layout_ == robcogen_gpu_by_element ? k * padded() + i
                                                : i * size + k;
  }
};

// Seconds of one call: the smallest mean of several runs of calls that take at least 20 ms together.
template <class F>
double seconds(F call) {
  using Clock = std::chrono::steady_clock;
  const auto timed = [&](int calls) {
    wait();
    const auto start = Clock::now();
    for (int k = 0; k < calls; ++k) call();
    wait();
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  call();
  int calls = 1;
  while (timed(calls) < 0.02) calls *= 2;
  double best = timed(calls);
  for (int k = 0; k < 4; ++k) best = std::fmin(best, timed(calls));
  return best / calls;
}

class Bench {
 public:
  // Options: --check (no times), --states N (times up to N states only), and parts of names of functions.
  Bench(int count, char** arguments) {
    for (int k = 1; k < count; ++k) {
      const std::string argument = arguments[k];
      if (argument == "--check")
        most_ = 0;
      else if (argument == "--states" && k + 1 < count)
        most_ = std::atol(arguments[++k]);
      else
        names_.push_back(argument);
    }
  }

  template <class Number>
  void run(const BenchFunction<Number>& f) {
    bool is_asked = names_.empty();
    for (const std::string& name : names_) is_asked = is_asked || std::strstr(f.name, name.c_str());
    if (!is_asked) return;
    ++functions_;
    const char* const scalar = sizeof(Number) == 4 ? "float" : "double";
    double worst = 0;
    for (const robcogen_gpu_layout layout : {robcogen_gpu_by_tile, robcogen_gpu_by_element})
      for (const int n : {1, 33, 1000}) worst = std::fmax(worst, difference(f, n, layout));
    std::printf("%-48s %-6s largest difference: %.2g of the tolerance\n", f.name, scalar, worst);
    if (!(worst <= 1)) ++failures_;
    for (std::ptrdiff_t n = 32; n <= most_ && measure(f, scalar, n); n *= 8) continue;
  }

  // The exit status of the program.
  int status() const {
    if (functions_ == 0)
      std::printf("no function has a name with these parts\n");
    else if (failures_ == 0)
      std::printf("all results agree with the host\n");
    else
      std::printf("%d functions differ from the host\n", failures_);
    return functions_ > 0 && failures_ == 0 ? 0 : 1;
  }

 private:
  std::vector<std::string> names_ = {};
  std::ptrdiff_t most_ = 1 << 20;
  int functions_ = 0, failures_ = 0;

  template <class Number>
  double difference(const BenchFunction<Number>& f, int n, robcogen_gpu_layout layout) {
    const BenchStates<Number> states(f, n, layout, 7);
    states.run();
    wait();
    return states.worst();
  }

  // Times per state: by tile, by element, and a copy of as many bytes, half of them read and half written. False if
  // these are more states than functions take (2^31 elements of an array) or than the memory of the device holds.
  template <class Number>
  bool measure(const BenchFunction<Number>& f, const char* scalar, std::ptrdiff_t n) {
    const auto states = static_cast<std::size_t>(n) + 32;
    std::size_t largest = f.workspace, sum = f.workspace;
    for (const BenchArray& a : f.arrays) {
      largest = a.size > largest ? a.size : largest;
      sum += 2 * a.size;  // and the copies
    }
    if (largest * states >= std::size_t{1} << 31 || sum * states * sizeof(Number) > available()) return false;
    double times[3] = {};
    std::size_t bytes = 0;
    for (const robcogen_gpu_layout layout : {robcogen_gpu_by_tile, robcogen_gpu_by_element}) {
      const BenchStates<Number> timed(f, n, layout, 7);
      bytes = timed.bytes();
      times[layout] = seconds([&] { timed.run(); });
    }
    const DeviceMemory<char> from(bytes / 2), to(bytes / 2);
    times[2] = seconds([&] { copy(to.data(), from.data(), from.bytes()); });
    const double each = 1e9 / static_cast<double>(n);
    std::printf(
        "%-48s %-6s %8ld  %10.4f by tile %10.4f by element %10.4f copy  ns a state\n", f.name, scalar,
        static_cast<long>(n), each * times[0], each * times[1], each * times[2]);
    return true;
  }
};

}  // namespace robcogen::gpu
