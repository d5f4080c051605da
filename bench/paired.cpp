// Times the same function of several libraries side by side, for paired.sh:
//     paired <size> <function> <library>…
// prints a line for each library: its number, then cycles of a call and the ratio to those of the first library, for
// calls in a row and for calls that each wait for the result of the previous one. All calls of a round follow one
// another within milliseconds, in random order; medians over the rounds are printed. The size is the number of joints,
// plus 6 for a floating base, whose coordinates follow those of the joints.
#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr std::size_t kStates = 256;
constexpr int kRounds = 21;
constexpr double kTolerance = 1e-9;  // of the largest element, as in the comparison with other libraries

using Kernel = void (*)(const double*, const double*, const double*, double*);
using Vector = std::vector<double>;

struct State {
  Vector q, first, second;
};

std::vector<State> random_states(std::size_t size, std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-2, 2);
  std::vector<State> states(kStates);
  for (State& s : states)
    for (Vector* v : {&s.q, &s.first, &s.second}) {
      v->resize(size);
      for (double& e : *v) e = uniform(engine);
    }
  return states;
}

double nanoseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::nano>(now).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Kernel load(const char* library, const char* function) {
  void* const handle = dlopen(library, RTLD_NOW);
  void* const symbol = handle ? dlsym(handle, function) : nullptr;
  if (!symbol) throw std::runtime_error(dlerror());
  return reinterpret_cast<Kernel>(symbol);
}

double time_in_a_row(Kernel kernel, const std::vector<State>& states, Vector& result) {
  const double start = nanoseconds();
  for (const State& s : states) kernel(s.q.data(), s.first.data(), s.second.data(), result.data());
  return (nanoseconds() - start) / kStates;
}

// Each call waits for the previous one: a multiple of its result that rounds to nothing is added to the next positions.
double time_waiting(Kernel kernel, const std::vector<State>& states, Vector& result) {
  Vector q = states[0].q;
  const double start = nanoseconds();
  for (std::size_t i = 0; i < kStates; ++i) {
    kernel(q.data(), states[i].first.data(), states[i].second.data(), result.data());
    double sum = 0.0;
    for (std::size_t k = 0; k < q.size(); ++k) sum += result[k];
    q = states[(i + 1) % kStates].q;
    for (double& e : q) e += 1e-300 * sum;
  }
  return (nanoseconds() - start) / kStates;
}

// Time (ns) of a cycle, from a chain of additions that take one cycle each.
double time_of_cycle() {
  constexpr int kAdditions = 1 << 16;
  std::uint64_t sum = 0;
  const double start = nanoseconds();
  for (int i = 0; i < kAdditions; ++i) {
    ++sum;
    asm volatile("" : "+r"(sum));
  }
  return (nanoseconds() - start) / kAdditions;
}

void require_equal(const std::vector<Kernel>& kernels, const std::vector<State>& states) {
  for (const State& s : states) {
    std::vector<Vector> results(kernels.size(), Vector(s.q.size() * s.q.size()));
    double largest = 0.0;
    for (std::size_t i = 0; i < kernels.size(); ++i)
      kernels[i](s.q.data(), s.first.data(), s.second.data(), results[i].data());
    for (const double e : results[0]) largest = std::max(largest, std::abs(e));
    for (const Vector& result : results)
      for (std::size_t k = 0; k < result.size(); ++k)
        if (!(std::abs(result[k] - results[0][k]) <= kTolerance * largest))
          throw std::runtime_error("the libraries disagree");
  }
}

void run(std::size_t size, const std::vector<Kernel>& kernels) {
  std::mt19937 engine(1);
  const std::vector<State> states = random_states(size, engine);
  require_equal(kernels, states);
  struct Times {
    std::vector<double> row, row_ratio, waiting, waiting_ratio;
  };
  std::vector<Times> times(kernels.size());
  std::vector<double> cycles;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < kernels.size(); ++i) order.push_back(i);
  Vector result(size * size);
  for (int round = 0; round < kRounds; ++round) {
    std::shuffle(order.begin(), order.end(), engine);
    for (const std::size_t i : order) {  // the lesser of two times, because the first call fills the caches
      const auto lesser = [](auto time) { return std::min(time(), time()); };
      times[i].row.push_back(lesser([&] { return time_in_a_row(kernels[i], states, result); }));
      times[i].waiting.push_back(lesser([&] { return time_waiting(kernels[i], states, result); }));
    }
    cycles.push_back(time_of_cycle());
    for (Times& t : times) {
      t.row_ratio.push_back(t.row.back() / times[0].row.back());
      t.waiting_ratio.push_back(t.waiting.back() / times[0].waiting.back());
    }
  }
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const Times& t = times[i];
    const double cycle = median(cycles);
    std::printf(
        "%zu %.1f %.4f %.1f %.4f\n", i + 1, median(t.row) / cycle, median(t.row_ratio), median(t.waiting) / cycle,
        median(t.waiting_ratio));
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 4) throw std::runtime_error("paired <size> <function> <library>…");
    std::vector<Kernel> kernels;
    for (int i = 3; i < argc; ++i) kernels.push_back(load(argv[i], argv[2]));
    run(std::stoul(argv[1]), kernels);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "paired: %s\n", error.what());
    return 1;
  }
  return 0;
}
