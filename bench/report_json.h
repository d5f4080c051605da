// The report as data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results.h"

namespace robcogen::bench {

// The conditions of the measurement. Empty where unknown.
struct Setup {
  std::string compiler;
  std::string flags;
  std::string processor;
  std::optional<int> pinned_to;  // number of the processor
  int repetitions = 0;
  double min_time = 0;  // of a repetition, s
};

// All rows, ratios, means and absences, with units and setup; no host, path or date.
std::string report_json(const Setup& setup, const std::vector<Results>& robots);

}  // namespace robcogen::bench
