// A list of named numerical checks: the largest error of each over many samples, and a tolerance with a reason.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "robcogen/reference/matrix.h"

namespace robcogen::reference {

// The reference computes with more digits than the library, if the platform has them.
using Real = long double;

struct Tolerance {
  const char* name;
  double value;
  const char* reason;
};

// The prefix of the checks of single precision, and the factor of their tolerances. Tolerances are relative to the
// terms of the sums, or to these multiplied by the inverse of H, so they follow from the robot's condition.
inline constexpr const char* kInSingle = "float: ";
inline constexpr double kSingle = 0x1p25;

class Checks {
 public:
  // Selects whether the records that follow are of results in single precision or in double.
  void in_single(bool single) { single_ = single; }

  // Keeps the largest error of the check `name`; NaN counts as the largest of all.
  void record(const std::string& name, const Tolerance& tolerance, Real error, int sample) {
    Tolerance own = tolerance;
    if (single_) own.value *= kSingle;
    Entry& entry = entry_of((single_ ? kInSingle : "") + name, own);
    if (entry.sample < 0 || (!std::isnan(entry.error) && !(error <= entry.error))) {
      entry.error = error;
      entry.sample = sample;
    }
  }

  int size() const { return static_cast<int>(entries_.size()); }
  int failures() const {
    return static_cast<int>(std::count_if(entries_.begin(), entries_.end(), [](const Entry& e) { return failed(e); }));
  }

  // One line per check: for all checks, or for those that failed.
  std::string report() const {
    return lines([](const Entry&) { return true; });
  }
  std::string failure_report() const { return lines(failed); }

 private:
  struct Entry {
    std::string name;
    Tolerance tolerance;
    Real error;
    int sample;
  };

  static bool failed(const Entry& e) { return !(e.error <= static_cast<Real>(e.tolerance.value)); }

  static std::string line(const Entry& e) {
    char text[200];
    std::snprintf(
        text, sizeof text, "%-4s  %-52s  error %9.2Le  tolerance %.0e (%s)", failed(e) ? "FAIL" : "ok", e.name.c_str(),
        e.error, e.tolerance.value, e.tolerance.name);
    std::string result = text;
    if (failed(e)) result += "  worst in sample " + std::to_string(e.sample) + "; " + e.tolerance.reason;
    return result + "\n";
  }

  template <class Condition>
  std::string lines(const Condition& condition) const {
    std::string text;
    for (const Entry& e : entries_) {
      if (condition(e)) text += line(e);
    }
    return text;
  }

  Entry& entry_of(const std::string& name, const Tolerance& tolerance) {
    for (Entry& e : entries_) {
      if (e.name == name) return e;
    }
    entries_.push_back({name, tolerance, 0, -1});
    return entries_.back();
  }

  std::vector<Entry> entries_;  // in the order of their first record
  bool single_ = false;
};

// The largest of some errors; NaN counts as the largest of all.
inline Real worst_of(std::initializer_list<Real> errors) {
  Real worst = 0;
  for (const Real error : errors) {
    if (std::isnan(error)) return error;
    worst = std::max(worst, error);
  }
  return worst;
}

// The largest difference between elements, each relative to the sum of magnitudes of the terms of that element.
// Elements far smaller than the largest are judged by that one, because their terms carry its rounding errors.
inline Real relative_error(const Matrix<Real>& actual, const Matrix<Real>& expected, const Matrix<Real>& terms) {
  constexpr Real kFar = 1e-4L;
  const Real floor = kFar * largest(terms);
  Real worst = 0;
  for (int j = 0; j < actual.cols(); ++j) {
    for (int i = 0; i < actual.rows(); ++i) {
      const Real difference = std::abs(actual(i, j) - expected(i, j));
      if (difference != 0) worst = worst_of({worst, difference / (std::abs(terms(i, j)) + floor)});
    }
  }
  return worst;
}

}  // namespace robcogen::reference
