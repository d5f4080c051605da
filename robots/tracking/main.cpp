// Runs the experiment at two rates with both control laws, prints tracking errors and loop times, and draws them.
//
//   hyl_tracking FILE.svg [SECONDS]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "picture.h"
#include "tracking.h"

namespace {

// The value below which this fraction of all values lies.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = std::ceil(share * static_cast<double>(sorted.size())) - 1;
  return sorted[static_cast<std::size_t>(std::max(place, 0.0))];
}

void print_times(const char* name, std::vector<double> nanoseconds) {
  std::sort(nanoseconds.begin(), nanoseconds.end());
  std::printf(
      "%-26s %9.0f %9.0f %9.0f\n", name, quantile(nanoseconds, 0.5), quantile(nanoseconds, 0.999), nanoseconds.back());
}

// Times of the clock calls themselves, which are part of the times above.
std::vector<double> clock_times(std::size_t count) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times(count);
  for (double& time : times) {
    const Clock::time_point before = Clock::now();
    time = std::chrono::duration<double, std::nano>(Clock::now() - before).count();
  }
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  char* end = nullptr;
  const double duration = argc == 3 ? std::strtod(argv[2], &end) : 20;
  if (argc < 2 || argc > 3 || (argc == 3 && (*end != '\0' || !(duration >= 1.2 && duration <= 1000)))) {
    std::fprintf(stderr, "usage: %s FILE.svg [SECONDS]    (1.2 to 1000 s of simulated time; 20)\n", argv[0]);
    return 2;
  }
  using tracking::Law;
  std::vector<tracking::Result> runs;
  for (const Law law : {Law::proportional_derivative, Law::inverse_dynamics})
    for (const double rate : {250.0, 1000.0}) runs.push_back(tracking::run(law, rate, duration));

  std::printf("The HyL leg tracks a sinusoid of %g Hz for %g s\n\n", tracking::kFrequency, duration);
  std::printf("%-26s %9s %9s %9s %9s\n", "tracking error [degrees]", "hip RMS", "largest", "knee RMS", "largest");
  for (const tracking::Result& run : runs) {
    const Eigen::Vector2d rms = run.rms * 180 / M_PI, largest = run.largest * 180 / M_PI;
    std::printf(
        "%-26s %9.3f %9.3f %9.3f %9.3f\n", tracking::name_of(run).c_str(), rms[0], largest[0], rms[1], largest[1]);
  }
  std::printf("\n%-26s %9s %9s %9s\n", "time of a loop [ns]", "median", "99.9 %", "worst");
  for (const tracking::Result& run : runs) print_times(tracking::name_of(run).c_str(), run.loop_times);
  print_times("(the clock alone)", clock_times(runs.back().loop_times.size()));

  std::ofstream file(argv[1]);
  file << tracking::picture(runs);
  file.close();
  if (!file) {
    std::fprintf(stderr, "%s: cannot write %s\n", argv[0], argv[1]);
    return 2;
  }
  std::printf("\nPicture: %s\n\n", argv[1]);
}
