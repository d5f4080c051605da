// Output that both programs print and write.
#pragma once

#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

#include "studies.h"

namespace design {

inline double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Time of an update with new values, ns.
inline double update_time() {
  constexpr int kTimes = 100000;
  Parameters parameters;
  ParameterArray values = parameters.array();
  const double before = seconds();
  double sum = 0;
  for (int i = 0; i < kTimes; ++i) {
    values[index_of("lower_length")] = 0.3 + 1e-6 * i;
    parameters.update(values);
    sum += parameters.data()[parameters.size() - 1];
  }
  const double time = seconds() - before;
  return sum == 0 ? 0 : 1e9 * time / kTimes;
}

inline void print_head(const char* study, const char* unit) {
  std::printf("%-44s %8s %8s %6s %9s %9s %6s\n", study, "upper m", "lower m", "ratio", "kg m^2", unit, "calls");
}

// `sign` is -1 if the value was maximised.
inline void print(const std::string& study, const Optimum& optimum, int sign = 1) {
  std::printf("%-44s %8.3f %8.3f", study.c_str(), optimum.x[0], optimum.x[1]);
  if (optimum.x.size() > 2) {
    std::printf(" %6.1f %9.2e", optimum.x[2], optimum.x[3]);
  } else {
    std::printf(" %6s %9s", "", "");
  }
  std::printf(" %9.3f %6d%s\n", sign * optimum.value, optimum.evaluations, optimum.is_complete ? "" : " (stopped)");
}

inline void print_absence() {
  std::printf("Searches over several parameters take NLopt (Debian: libnlopt-dev), which this build does not have.\n");
}

// Writes the picture and returns the exit status.
inline int write(const char* program, const char* name, const std::string& picture) {
  std::ofstream file(name);
  file << picture;
  file.close();
  if (!file) {
    std::fprintf(stderr, "%s: cannot write %s\n", program, name);
    return 2;
  }
  std::printf("\nPicture: %s\n\n", name);
  return 0;
}

}  // namespace design
