// How many digits a program keeps: its results in double and in float are compared with those of a reference program of
// the same function, evaluated with 32 digits.
//
// The measure uses a few states, the same for all programs of a function, and only IEEE operations of double and float,
// so that it is the same on every machine.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Rounding errors of a program, in units of the relative rounding error of one operation (2^-53, 2^-24). In each state,
// the error of an output array is the largest error of its elements, relative to its largest element in that state or
// to a quarter of the root mean square of that over the states, whichever is larger. The value here is the root mean
// square of these errors over the states, for the output array where it is largest. It is infinite if a result is not
// finite that should be.
struct RoundingError {
  double in_double = 0.0;
  double in_float = 0.0;
};

struct Accuracy {
  RoundingError error;
  // Whether the program may replace the plain one: none of its output arrays loses more digits, and float keeps four
  // bits of each pivot (a divisor, or the argument of a square root). If float keeps fewer, no other program is sure to
  // give finite results as often as the plain one.
  bool is_kept = false;
};

// `3.1 in double, 2.9 in float`
std::string print(const RoundingError& error);
// The error as text: `3.1`, `25`, `1.2e+05`, `inf`.
std::string print_error(double error);

// The reference results of a function.
class AccurateResults {
 public:
  // `program`: a program without lanes. `parameters`: the values of its input with the role `parameters`; missing ones
  // are one.
  explicit AccurateResults(const Program& program, std::vector<double> parameters = {});
  ~AccurateResults();

  // The error of the reference program itself in double and in float.
  RoundingError error_of_plain() const;
  // The accuracy of another program of the same function, with or without lanes.
  Accuracy accuracy_of(const Program& program) const;
  RoundingError error_of(const Program& program) const { return accuracy_of(program).error; }
  bool are_kept_by(const Program& program) const { return accuracy_of(program).is_kept; }

 private:
  struct Results;
  std::unique_ptr<const Results> results_;
};

}  // namespace robcogen::symbolic
