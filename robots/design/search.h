// Looking for the smallest value of a function of a few variables: golden sections for one variable, NLopt for more.
#pragma once

#include <functional>
#include <vector>

namespace design {

struct Optimum {
  std::vector<double> x;
  double value;
  int evaluations;
  bool is_complete = true;  // not ended by the largest number of evaluations
};

// Of a function with one minimum between `lower` and `upper`, to this distance (Kiefer 1953). Each step takes one
// evaluation and leaves 0.618 of the interval.
Optimum golden_section(const std::function<double(double)>& function, double lower, double upper, double distance);

struct Variable {
  double lower, upper, start;
};

// The value; its gradient too where that is asked for (not null), as many elements as variables.
using Function = std::function<double(const std::vector<double>& x, double* gradient)>;

enum class Method {
  cobyla,  // linear models of values, without gradients (Powell 1994)
  slsqp,   // sequential quadratic programming, with gradients (Kraft 1988)
};

struct Problem {
  std::vector<Variable> variables;
  Function function;
  Function constraint = {};  // at most zero; may be empty
  double tolerance = 1e-6;   // of the value, relative
  int max_evaluations = 2000;
};

// Whether this program was built with NLopt.
bool can_minimise();

// Throws std::runtime_error where there is no NLopt, or where it fails.
Optimum minimise(const Problem& problem, Method method);

}  // namespace design
