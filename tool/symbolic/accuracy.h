// How many digits a program keeps: its results in double and in float are compared with another program of the same
// function that is evaluated with 32 digits.
//
// The measure uses a few states, the same for all programs of a function, and only IEEE operations of double and float,
// so that it is the same on every machine.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Rounding errors of a program, in units of the relative rounding error of one operation (2^-53, 2^-24): for each
// output array the largest error of an element, relative to the largest element of that state, or to a quarter of what
// that is on average; the root of the mean square over the states; of the output array where this is largest. Infinite
// where a result is not finite that should be.
struct RoundingError {
  double in_double = 0.0;
  double in_float = 0.0;
};

struct Accuracy {
  RoundingError error;
  // Whether the program may take the place of the plain one: none of its output arrays loses more, and float keeps four
  // bits of each pivot, the numbers that it divides by and takes the square root of. Where float does not, only the
  // plain program itself is as often finite as the plain program.
  bool is_kept = false;
};

// `3.1 in double, 2.9 in float`
std::string print(const RoundingError& error);
// Two digits.
std::string print_error(double error);

// The results that a function should have.
class AccurateResults {
 public:
  // Of a scalar program. `parameters` are the values of its
  // input of that role; ones where they are missing.
  explicit AccurateResults(const Program& program, std::vector<double> parameters = {});
  ~AccurateResults();

  // Of the program that these are the results of.
  RoundingError error_of_plain() const;
  // Of another program of the same function, with lanes or without.
  Accuracy accuracy_of(const Program& program) const;
  RoundingError error_of(const Program& program) const { return accuracy_of(program).error; }
  bool are_kept_by(const Program& program) const { return accuracy_of(program).is_kept; }

 private:
  struct Results;
  std::unique_ptr<const Results> results_;
};

}  // namespace robcogen::symbolic
