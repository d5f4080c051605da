#include "search.h"

#include <cmath>
#include <stdexcept>

#ifdef DESIGN_HAS_NLOPT
#include <nlopt.h>

#include <memory>
#include <string>
#endif

namespace design {

Optimum golden_section(const std::function<double(double)>& function, double lower, double upper, double distance) {
  const double share = (std::sqrt(5) - 1) / 2;
  double left = upper - share * (upper - lower), right = lower + share * (upper - lower);
  double at_left = function(left), at_right = function(right);
  int evaluations = 2;
  while (upper - lower > distance) {
    if (at_left < at_right) {
      upper = right;
      right = left;
      at_right = at_left;
      left = upper - share * (upper - lower);
      at_left = function(left);
    } else {
      lower = left;
      left = right;
      at_left = at_right;
      right = lower + share * (upper - lower);
      at_right = function(right);
    }
    ++evaluations;
  }
  const bool is_left = at_left < at_right;
  return {{is_left ? left : right}, is_left ? at_left : at_right, evaluations, true};
}

#ifdef DESIGN_HAS_NLOPT

namespace {

nlopt_algorithm algorithm_of(Method method) {
  return method == Method::slsqp ? NLOPT_LD_SLSQP : NLOPT_LN_COBYLA;
}

// NLopt gets variables scaled to 0 to 1, because lengths and inertias differ by orders of magnitude.
struct Scaled {
  const std::vector<Variable>& variables;
  const Function& function;
  int evaluations = 0;

  std::vector<double> unscaled(const double* y) const {
    std::vector<double> x;
    for (const Variable& v : variables) x.push_back(v.lower + y[x.size()] * (v.upper - v.lower));
    return x;
  }

  static double call(unsigned n, const double* y, double* gradient, void* data) {
    auto& self = *static_cast<Scaled*>(data);
    ++self.evaluations;
    const double value = self.function(self.unscaled(y), gradient);
    if (gradient)
      for (unsigned i = 0; i < n; ++i) gradient[i] *= self.variables[i].upper - self.variables[i].lower;
    return value;
  }
};

}  // namespace

bool can_minimise() {
  return true;
}

Optimum minimise(const Problem& problem, Method method) {
  const auto n = static_cast<unsigned>(problem.variables.size());
  std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(nlopt_create(algorithm_of(method), n), nlopt_destroy);
  Scaled function{problem.variables, problem.function}, constraint{problem.variables, problem.constraint};
  nlopt_set_lower_bounds1(search.get(), 0);
  nlopt_set_upper_bounds1(search.get(), 1);
  nlopt_set_min_objective(search.get(), Scaled::call, &function);
  if (problem.constraint) nlopt_add_inequality_constraint(search.get(), Scaled::call, &constraint, 1e-9);
  nlopt_set_ftol_rel(search.get(), problem.tolerance);
  nlopt_set_xtol_abs1(search.get(), 1e-5);
  nlopt_set_initial_step1(search.get(), 0.1);
  nlopt_set_maxeval(search.get(), problem.max_evaluations);

  std::vector<double> y;
  for (const Variable& v : problem.variables) y.push_back((v.start - v.lower) / (v.upper - v.lower));
  double value = 0;
  const nlopt_result result = nlopt_optimize(search.get(), y.data(), &value);
  // Rounding ends a search that cannot improve any more, so its result is good.
  if (result < 0 && result != NLOPT_ROUNDOFF_LIMITED)
    throw std::runtime_error(std::string("NLopt: ") + nlopt_result_to_string(result));
  return {function.unscaled(y.data()), value, function.evaluations, result != NLOPT_MAXEVAL_REACHED};
}

#else

bool can_minimise() {
  return false;
}

Optimum minimise(const Problem&, Method) {
  throw std::runtime_error("built without NLopt: install it (Debian: libnlopt-dev) and configure anew");
}

#endif

}  // namespace design
