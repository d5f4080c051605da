// Searches for the smallest value of a function of a few variables: golden sections for one variable, NLopt for more.
#pragma once

#include <functional>
#include <vector>

namespace design {

struct Optimum {
  std::vector<double> x;
  double value;
  int evaluations;
  bool is_complete = true;  // false: ended by the largest number of evaluations
};

// Minimum of a function that has one minimum between `lower` and `upper`, to this distance (Kiefer 1953). Each step
// takes one evaluation and leaves 0.618 of the interval.
Optimum golden_section(const std::function<double(double)>& function, double lower, double upper, double distance);

struct Variable {
  double lower, upper, start;
};

// Returns the value, and writes its gradient (one element per variable) if the pointer is not null.
using Function = std::function<double(const std::vector<double>& x, double* gradient)>;

enum class Method {
  cobyla,  // linear models of values, without gradients (Powell 1994)
  slsqp,   // sequential quadratic programming, with gradients (Kraft 1988)
};

struct Problem {
  std::vector<Variable> variables;
  Function function;
  Function constraint = {};  // must be at most zero; may be empty
  double tolerance = 1e-6;   // of the value, relative
  int max_evaluations = 2000;
};

// Whether this program was built with NLopt.
bool can_minimise();

// Throws std::runtime_error if the program was built without NLopt, or if NLopt fails.
Optimum minimise(const Problem& problem, Method method);

}  // namespace design
