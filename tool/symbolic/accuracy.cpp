#include "symbolic/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "support/index.h"
#include "symbolic/interpret.h"
#include "symbolic/states.h"

namespace robcogen::symbolic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A program's error may be this many times that of the plain one …
constexpr double kShare = 2.5;
// … or this many roundings, which is how much different orders of the same sums differ. kFloor is for the root mean
// square, which a single state near a singular configuration can dominate; kTypicalFloor is for the geometric mean,
// which it cannot.
constexpr double kFloor = 8.0;
constexpr double kTypicalFloor = 4.0;

// A pivot (a divisor, or the argument of a square root) may lose this share of its value in float. The output arrays do
// not show such a loss: their largest elements come from other pivots. A pivot that loses all of its value may change
// its sign, and then a few roundings more or less than in the plain program decide whether a result is NaN.
constexpr double kLostOfPivot = 1.0 / 16;

// The same share in roundings of float.
constexpr double kLostRoundings = 0x1p24 * kLostOfPivot;

// In a state in which results cancel, errors are measured relative to this share of the usual size of the results.
constexpr double kLeastScale = 0.25;

// The constants and inputs of a program in all states.
template <class Real>
class Leaves {
 public:
  Leaves(const Program& program, const std::vector<Batch<double>>& inputs) {
    for (const Batch<double>& input : inputs)
      inputs_.push_back(in_all_states<Real>([&](std::size_t s) { return rounded<Real>({input.value[s], 0.0}); }));
    for (const Constant& c : program.constants)
      constants_.push_back(in_all_states<Real>([&](std::size_t) { return literal_as<Real>(c.number()); }));
  }

  const Batch<Real>& operator()(const Operand& o) const { return (is_constant(o) ? constants_ : inputs_)[at(o.index)]; }

 private:
  std::vector<Batch<Real>> constants_, inputs_;
};

template <class Real>
using InStates = Interpreter<Batch<Real>, Leaves<Real>>;

const OutputArray& output_of(const Program& program, const std::string& name) {
  const auto found = std::find_if(
      program.outputs.begin(), program.outputs.end(), [&](const OutputArray& array) { return array.name == name; });
  if (found == program.outputs.end()) throw std::logic_error("the program has no output '" + name + "'");
  return *found;
}

// The error of one output array, in roundings.
struct ArrayError {
  double mean_square = 0.0;  // root mean square
  double typical = 0.0;      // geometric mean
};

struct Errors {
  std::vector<ArrayError> in_double, in_float;  // by output array
  double of_pivots = 0.0;
};

// The largest error of any pivot in float over all states, relative to its value in double.
double error_of_pivots(const Program& program, const InStates<double>& in_double, const InStates<float>& in_float) {
  double largest = 0.0;
  for (const Statement& s : program.statements) {
    if (s.op != Op::divide && s.op != Op::square_root) continue;
    const Operand& pivot = s.op == Op::divide ? s.b : s.a;
    for (int lane = 0; lane < s.width; ++lane) {
      const Batch<double> expected = in_double.read(pivot, lane);
      const Batch<float> found = in_float.read(pivot, lane);
      for (std::size_t k = 0; k < kStates; ++k) {
        const double exact = expected.value[k], value = found.value[k];
        if (!std::isfinite(exact) || value == exact) continue;
        const double error = std::abs((value - exact) / exact);
        largest = std::isnan(error) ? kInfinity : std::max(largest, error);
      }
    }
  }
  return largest;
}

// States whose scale is zero are not compared.
double root_of_mean_square(const std::array<double, kStates>& errors, const std::array<double, kStates>& scales) {
  double squares = 0.0, count = 0.0;
  for (std::size_t s = 0; s < kStates; ++s) {
    if (scales[s] == 0.0) continue;
    squares += errors[s] * errors[s];
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

// An error counts as at least one rounding and at most `all`, the loss of all digits. The mean is computed by square
// roots of pairs, because logarithms differ between machines.
double geometric_mean(std::array<double, kStates> errors, double all) {
  for (double& error : errors) error = std::clamp(error, 1.0, all);
  for (std::size_t n = kStates / 2; n > 0; n /= 2)
    for (std::size_t s = 0; s < n; ++s) errors[s] = std::sqrt(errors[s] * errors[s + n]);
  return errors[0];
}

double worst(const std::vector<ArrayError>& errors) {
  double result = 0.0;
  for (const ArrayError& error : errors) result = std::max(result, error.mean_square);
  return result;
}

// Compares array by array: the error of one array does not excuse the same error in another. Counted in roundings, a
// program has about the same error in double and in float. So the plain program's mean squares in the two precisions
// are two measurements of one number, and the larger one counts: where a single state dominates them, the other may be
// small by chance. An error that costs float nearly all its bits is no such measurement: it may have other causes.
bool is_as_accurate(
    const std::vector<ArrayError>& errors,
    const std::vector<ArrayError>& plain,
    const std::vector<ArrayError>& plain_in_other_precision) {
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double other = plain_in_other_precision[i].mean_square;
    const double mean_square = std::max(plain[i].mean_square, other < kLostRoundings ? other : 0.0);
    if (!(errors[i].mean_square <= std::max(kShare * mean_square, kFloor))) return false;
    if (!(errors[i].typical <= std::max(kShare * plain[i].typical, kTypicalFloor))) return false;
  }
  return true;
}

}  // namespace

struct AccurateResults::Results {
  struct Output {
    std::string name;
    std::vector<Batch<DoubleDouble>> values;
    std::array<double, kStates> scale;  // the largest value of each state; zero for states that are not compared
  };
  std::vector<Output> outputs;
  std::vector<double> parameters;

  Errors of_plain;

  template <class Real>
  std::vector<ArrayError> errors_of(const Program& program, const InStates<Real>& values, double rounding) const {
    std::vector<ArrayError> result;
    for (const Output& expected : outputs) {
      const OutputArray& found = output_of(program, expected.name);
      std::array<double, kStates> largest{};
      for (std::size_t k = 0; k < expected.values.size(); ++k) {
        const Batch<Real> value = values.read(found.values[k]);
        for (std::size_t s = 0; s < kStates; ++s) {
          const DoubleDouble exact = get(expected.values[k], s);
          const double error = std::abs((static_cast<double>(get(value, s)) - exact.high) - exact.low);
          largest[s] = std::isnan(error) ? kInfinity : std::max(largest[s], error);
        }
      }
      for (std::size_t s = 0; s < kStates; ++s)
        largest[s] = expected.scale[s] == 0.0 ? 0.0 : largest[s] / expected.scale[s] / rounding;
      result.push_back({root_of_mean_square(largest, expected.scale), geometric_mean(largest, 1.0 / rounding)});
    }
    return result;
  }

  Errors errors_of(const Program& program) const {
    constexpr double kOfDouble = 0x1p-53, kOfFloat = 0x1p-24;
    const std::vector<Batch<double>> inputs = inputs_of(program, parameters);
    const InStates<double> in_double(program, {program, inputs});
    const InStates<float> in_float(program, {program, inputs});
    return {
        errors_of(program, in_double, kOfDouble), errors_of(program, in_float, kOfFloat),
        error_of_pivots(program, in_double, in_float)};
  }
};

AccurateResults::AccurateResults(const Program& program, std::vector<double> parameters) {
  auto results = std::make_unique<Results>();
  results->parameters = std::move(parameters);
  const InStates<DoubleDouble> values(program, {program, inputs_of(program, results->parameters)});
  for (const OutputArray& array : program.outputs) {
    if (array.role == Role::residual) continue;
    Results::Output& output = results->outputs.emplace_back();
    output.name = array.name;
    output.scale.fill(0.0);
    for (const Operand& o : array.values) {
      output.values.push_back(values.read(o));
      for (std::size_t s = 0; s < kStates; ++s) {
        const double size = std::abs(output.values.back().high[s]);
        output.scale[s] = std::isfinite(size) ? std::max(output.scale[s], size) : kInfinity;
      }
    }
    // A state in which the reference overflows is not compared.
    double squares = 0.0;
    for (double& scale : output.scale) {
      if (scale == kInfinity) scale = 0.0;
      squares += scale * scale;
    }
    const double least = kLeastScale * std::sqrt(squares / kStates);
    for (double& scale : output.scale)
      if (scale > 0.0) scale = std::max(scale, least);
  }
  results->of_plain = results->errors_of(program);
  results_ = std::move(results);
}

AccurateResults::~AccurateResults() = default;

RoundingError AccurateResults::error_of_plain() const {
  return {worst(results_->of_plain.in_double), worst(results_->of_plain.in_float)};
}

Accuracy AccurateResults::accuracy_of(const Program& program) const {
  const Errors own = results_->errors_of(program);
  const Errors& plain = results_->of_plain;
  return {
      {worst(own.in_double), worst(own.in_float)},
      own.of_pivots <= kLostOfPivot && is_as_accurate(own.in_double, plain.in_double, plain.in_float) &&
          is_as_accurate(own.in_float, plain.in_float, plain.in_double)};
}

std::string print_error(double error) {
  if (!std::isfinite(error)) return "inf";
  return error < 9.95  ? fmt::format("{:.1f}", error)
         : error < 1e4 ? fmt::format("{:.0f}", error)
                       : fmt::format("{:.1e}", error);
}

std::string print(const RoundingError& error) {
  return print_error(error.in_double) + " in double, " + print_error(error.in_float) + " in float";
}

}  // namespace robcogen::symbolic
