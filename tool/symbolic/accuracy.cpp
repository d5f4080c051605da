#include "symbolic/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>

#include "support/index.h"
#include "symbolic/double_double.h"

namespace robcogen::symbolic {
namespace {

constexpr std::size_t kStates = 16;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A program may lose this many times as much as the plain one …
constexpr double kShare = 2.5;
// … or this many roundings, which is what different orders of the same sums differ by: as the root of the mean square,
// which a single state near a singular position can decide, and as the geometric mean, which it cannot.
constexpr double kFloor = 8.0;
constexpr double kTypicalFloor = 4.0;

// A pivot, which is what a program divides by or takes the square root of, may lose this share of itself in float. The
// output arrays do not show it: their largest elements are those of other pivots. At a loss of one it changes its sign,
// and whether a result is a number is luck: a few roundings more or less than those of the plain program decide.
constexpr double kLostOfPivot = 1.0 / 16;

// A state in which results cancel is compared with this share of their usual size.
constexpr double kLeastScale = 0.25;

// A value in all states.
template <class Real>
struct Batch {
  std::array<Real, kStates> value;
};
template <>
struct Batch<DoubleDouble> {
  std::array<double, kStates> high, low;
};

template <class Real>
Real get(const Batch<Real>& batch, std::size_t state) {
  if constexpr (std::is_same_v<Real, DoubleDouble>)
    return {batch.high[state], batch.low[state]};
  else
    return batch.value[state];
}

template <class Real>
void set(Batch<Real>& batch, std::size_t state, const Real& value) {
  if constexpr (std::is_same_v<Real, DoubleDouble>) {
    batch.high[state] = value.high;
    batch.low[state] = value.low;
  } else {
    batch.value[state] = value;
  }
}

template <class Real>
Real rounded(const DoubleDouble& x) {
  if constexpr (std::is_same_v<Real, DoubleDouble>)
    return x;
  else
    return static_cast<Real>(x.high);
}

DoubleDouble exact(std::int64_t n) {
  constexpr std::int64_t kHalf = std::int64_t{1} << 32;
  return two_sum(static_cast<double>(n / kHalf) * static_cast<double>(kHalf), static_cast<double>(n % kHalf));
}

// As in the generated code literals are doubles, which are what the results are judged by; multiples of PI are exact.
template <class Real>
Real literal_as(const Number& n) {
  if constexpr (std::is_same_v<Real, DoubleDouble>) {
    if (!n.is_pi_multiple()) return {n.value(), 0.0};
    return kPiPair * (exact(n.ratio()->num) / exact(n.ratio()->den));
  } else {
    return static_cast<Real>(n.value());
  }
}

// Numbers without pattern that are the same everywhere (splitmix64).
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// Between -1 and 1, with few enough digits for a float.
double number_of(const std::string& array, std::size_t element, std::size_t state) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : array) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  const std::uint64_t bits = scrambled(scrambled(hash + element) + state);
  constexpr double kScale = 1 << 16;
  return static_cast<double>(static_cast<std::int64_t>(bits >> 47) - (1 << 16)) / kScale;
}

// As numbers of a float, whose norm is one but for their rounding.
std::array<double, 4> unit_quaternion(const std::string& array, std::size_t first, std::size_t state) {
  std::array<double, 4> q{};
  double square = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    q[i] = number_of(array, first + i, state) + (i == 0 ? 0.125 : 0.0);
    square += q[i] * q[i];
  }
  for (double& e : q) e = static_cast<double>(static_cast<float>(e / std::sqrt(square)));
  return q;
}

double input_of(
    const InputArray& array,
    std::size_t element,
    std::size_t state,
    const std::vector<double>& parameters) {
  const double x = number_of(array.name, element, state);
  for (const int first : array.quaternions)
    if (const int i = static_cast<int>(element) - first; i >= 0 && i < 4)
      return unit_quaternion(array.name, at(first), state)[at(i)];
  switch (array.role) {
    case Role::parameters:
      return element < parameters.size() ? parameters[element] : 1.0 + 0.25 * x;
    case Role::joint_position:
      return 3.0 * x;
    case Role::gravity:
      return 10.0 * x;
    case Role::inertia_factor:
      return 0.125 * x;
    case Role::inverse_diagonal:
      return 1.0 + 0.5 * x;
    case Role::contact_activity:
      return x > -0.5 ? 1.0 : 0.0;
    case Role::contact_compliance:
      return 1.0 + 0.5 * x;
    default:
      return 2.0 * x;
  }
}

// Runs programs in all states at once.
template <class Real>
class Evaluator {
 public:
  using Values = Batch<Real>;

  Evaluator(const Program& program, const std::vector<double>& parameters) : program_(program) {
    for (const InputArray& array : program.inputs) {
      for (std::size_t k = 0; k < array.elements.size(); ++k) {
        Values& input = inputs_.emplace_back();
        for (std::size_t s = 0; s < kStates; ++s)
          set(input, s, rounded<Real>({input_of(array, k, s, parameters), 0.0}));
      }
    }
    for (const Number& n : program.constants) {
      Values& constant = constants_.emplace_back();
      for (std::size_t s = 0; s < kStates; ++s) set(constant, s, literal_as<Real>(n));
    }
    first_.reserve(program.statements.size());
    computed_.reserve(program.statements.size());
    for (const Statement& statement : program.statements) run(statement);
  }

  Values read(const Operand& o, int lane = 0) const {
    Values x = whole(o, lane);
    if (o.negative)
      for (std::size_t s = 0; s < kStates; ++s) set(x, s, -get(x, s));
    return x;
  }

 private:
  const Program& program_;
  std::vector<Values> inputs_, constants_;
  std::vector<Values> computed_;    // lane by lane
  std::vector<std::size_t> first_;  // lane of each statement

  const Values& whole(const Operand& o, int lane) const {
    const std::size_t i = at(o.index);
    if (is_constant(o)) return constants_[i];
    if (o.kind == Operand::Kind::input) return inputs_[i];
    const int own = o.lane >= 0 ? o.lane : program_.statements[i].width > 1 ? lane : 0;
    return computed_[first_[i] + at(own)];
  }

  void run(const Statement& s) {
    first_.push_back(computed_.size());
    if (s.op == Op::sum_lanes) {
      Values sum = read(s.a, 0);
      for (int lane = 1; lane < program_.statements[at(s.a.index)].width; ++lane)
        sum = combined(Op::add, sum, read(s.a, lane));
      computed_.push_back(sum);
      return;
    }
    for (int lane = 0; lane < s.width; ++lane) {
      if (s.op == Op::gather)
        computed_.push_back(read(s.lanes[at(lane)]));
      else if (is_binary(s.op))
        computed_.push_back(combined(s.op, read(s.a, lane), read(s.b, lane)));
      else
        computed_.push_back(function(s.op, read(s.a, lane)));
    }
  }

  template <class F>
  static Values each(const Values& a, const Values& b, F f) {
    Values result;
    for (std::size_t s = 0; s < kStates; ++s) set(result, s, f(get(a, s), get(b, s)));
    return result;
  }

  static Values combined(Op op, const Values& a, const Values& b) {
    switch (op) {
      case Op::add:
        return each(a, b, [](const Real& x, const Real& y) { return x + y; });
      case Op::subtract:
        return each(a, b, [](const Real& x, const Real& y) { return x - y; });
      case Op::multiply:
        return each(a, b, [](const Real& x, const Real& y) { return x * y; });
      case Op::divide:
        return each(a, b, [](const Real& x, const Real& y) { return x / y; });
      case Op::arc_tangent:
        return each(a, b, [](const Real& x, const Real& y) {
          using std::atan2;
          return atan2(x, y);
        });
      default:
        throw std::logic_error("not an operation on two numbers");
    }
  }

  static Values function(Op op, const Values& a) {
    using std::sqrt;
    Values result;
    for (std::size_t s = 0; s < kStates; ++s) {
      const Real x = get(a, s);
      if (op == Op::square_root) {
        set(result, s, sqrt(x));
        continue;
      }
      DoubleDouble angle;
      if constexpr (std::is_same_v<Real, DoubleDouble>)
        angle = x;
      else
        angle.high = static_cast<double>(x);
      const SineCosine both = sine_cosine(angle);
      set(result, s, rounded<Real>(op == Op::sine ? both.sine : both.cosine));
    }
    return result;
  }
};

const OutputArray& output_of(const Program& program, const std::string& name) {
  const auto found = std::find_if(
      program.outputs.begin(), program.outputs.end(), [&](const OutputArray& array) { return array.name == name; });
  if (found == program.outputs.end()) throw std::logic_error("the program has no output '" + name + "'");
  return *found;
}

// Of one output array, in roundings.
struct ArrayError {
  double mean_square = 0.0;  // its root
  double typical = 0.0;      // the geometric mean
};

struct Errors {
  std::vector<ArrayError> in_double, in_float;  // by output array
  double of_pivots = 0.0;
};

// The largest error of a pivot in float, relative to what it is in double, of all states.
double error_of_pivots(const Program& program, const Evaluator<double>& in_double, const Evaluator<float>& in_float) {
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

// `scales` are zero where nothing is to be compared.
double root_of_mean_square(const std::array<double, kStates>& errors, const std::array<double, kStates>& scales) {
  double squares = 0.0, count = 0.0;
  for (std::size_t s = 0; s < kStates; ++s) {
    if (scales[s] == 0.0) continue;
    squares += errors[s] * errors[s];
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

// Nothing counts as better than one rounding, or as worse than `all` digits lost. By square roots of pairs: no
// logarithms, which differ between machines.
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

// Array by array: the error of one array does not excuse the same error in another.
bool is_as_accurate(const std::vector<ArrayError>& errors, const std::vector<ArrayError>& plain) {
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!(errors[i].mean_square <= std::max(kShare * plain[i].mean_square, kFloor))) return false;
    if (!(errors[i].typical <= std::max(kShare * plain[i].typical, kTypicalFloor))) return false;
  }
  return true;
}

}  // namespace

struct AccurateResults::Results {
  struct Output {
    std::string name;
    std::vector<Batch<DoubleDouble>> values;
    std::array<double, kStates> scale;  // the largest value; zero where nothing is to be compared
  };
  std::vector<Output> outputs;
  std::vector<double> parameters;

  Errors of_plain;

  template <class Real>
  std::vector<ArrayError> errors_of(const Program& program, const Evaluator<Real>& evaluator, double rounding) const {
    std::vector<ArrayError> result;
    for (const Output& expected : outputs) {
      const OutputArray& found = output_of(program, expected.name);
      std::array<double, kStates> largest{};
      for (std::size_t k = 0; k < expected.values.size(); ++k) {
        const Batch<Real> value = evaluator.read(found.values[k]);
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
    const Evaluator<double> in_double(program, parameters);
    const Evaluator<float> in_float(program, parameters);
    return {
        errors_of(program, in_double, kOfDouble), errors_of(program, in_float, kOfFloat),
        error_of_pivots(program, in_double, in_float)};
  }
};

AccurateResults::AccurateResults(const Program& program, std::vector<double> parameters) {
  auto results = std::make_unique<Results>();
  results->parameters = std::move(parameters);
  const Evaluator<DoubleDouble> evaluator(program, results->parameters);
  for (const OutputArray& array : program.outputs) {
    Results::Output& output = results->outputs.emplace_back();
    output.name = array.name;
    output.scale.fill(0.0);
    for (const Operand& o : array.values) {
      output.values.push_back(evaluator.read(o));
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
      own.of_pivots <= kLostOfPivot && is_as_accurate(own.in_double, plain.in_double) &&
          is_as_accurate(own.in_float, plain.in_float)};
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
