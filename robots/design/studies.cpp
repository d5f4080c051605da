#include "studies.h"

#include <algorithm>
#include <stdexcept>

namespace design {
namespace {

constexpr std::size_t kUpper = index_of("upper_length"), kLower = index_of("lower_length"),
                      kGear = index_of("gear_ratio"), kRotor = index_of("rotor_inertia");
constexpr std::size_t kPlaces[] = {kUpper, kLower, kGear, kRotor};  // of the variables of a search

constexpr double kLongest = 0.70, kShortest = 0.66;  // m, of upper and lower leg together

ParameterArray parameters_of(const std::vector<double>& x) {
  ParameterArray result = Parameters().array();
  for (std::size_t i = 0; i < x.size(); ++i) result[kPlaces[i]] = x[i];
  return result;
}

// The rise of a design, or zero if it cannot jump because its legs do not reach or its motors are too weak.
double rise_or_nothing(const ParameterArray& parameters, const Actuators& actuators) {
  try {
    return squat_jump(Parameters(parameters), kStarts[0], actuators).rise;
  } catch (const std::domain_error&) {
    return 0;
  }
}

// The constraint sign (upper + lower - length) <= 0.
Function limit_on_length(double sign, double length) {
  return [=](const std::vector<double>& x, double* gradient) {
    if (gradient) {
      std::fill(gradient, gradient + x.size(), 0.0);
      gradient[0] = gradient[1] = sign;
    }
    return sign * (x[0] + x[1] - length);
  };
}

// A power, with its gradient only if the pointer is not null, because the gradient costs more.
Function power_function(
    double (*value)(const ParameterArray&, const Trot&),
    Power (*with_gradient)(const ParameterArray&, const Trot&),
    double speed) {
  return [=](const std::vector<double>& x, double* gradient) {
    const Trot trot{speed};
    if (!gradient) return value(parameters_of(x), trot);
    const Power power = with_gradient(parameters_of(x), trot);
    for (std::size_t i = 0; i < x.size(); ++i) gradient[i] = power.gradient[static_cast<int>(kPlaces[i])];
    return power.value;
  };
}

const Variable kLeg{0.26, 0.46, 0.36};

}  // namespace

ParameterArray with_lengths(double upper, double lower) {
  return parameters_of({upper, lower});
}

double normalised_rise(double lower_length, double start, double torque_limit) {
  const Parameters parameters(with_lengths(kUpperLength, lower_length));
  return squat_jump(parameters, start, constant_limit(torque_limit)).rise / lower_length;
}

std::vector<Sample> jump_curve(double start, double torque_limit) {
  std::vector<Sample> curve;
  for (int i = 0; i < 12; ++i) {
    const double length = 0.26 + 0.02 * i;
    curve.push_back({length, normalised_rise(length, start, torque_limit)});
  }
  return curve;
}

std::vector<Sample> trot_curve(double speed) {
  std::vector<Sample> curve;
  for (int i = 0; i < 14; ++i) {
    const double ratio = 0.5 + 0.1 * i, lower = kTotalLength / (1 + ratio);
    curve.push_back({ratio, mechanical_power_value(with_lengths(kTotalLength - lower, lower), Trot{speed})});
  }
  return curve;
}

Optimum best_jump(double start, double torque_limit) {
  return golden_section([=](double lower) { return -normalised_rise(lower, start, torque_limit); }, 0.26, 0.48, 1e-3);
}

Problem jump_of_lengths() {
  const auto rise = [](const std::vector<double>& x, double*) {
    return -rise_or_nothing(parameters_of(x), constant_limit(kTorqueLimit));
  };
  return {{kLeg, {0.26, 0.46, 0.33}}, rise, limit_on_length(1, kLongest), 1e-5};
}

Problem jump_of_lengths_and_motors() {
  const auto rise = [](const std::vector<double>& x, double*) {
    return -rise_or_nothing(parameters_of(x), motors(parameters_of(x)));
  };
  // A jump takes milliseconds, and the four variables have a long and flat ridge.
  return {{kLeg, {0.26, 0.46, 0.33}, {4, 40, 12}, {2e-5, 2e-3, 5e-4}}, rise, limit_on_length(1, kLongest), 1e-5, 200};
}

Problem trot_of_lengths(double speed) {
  return {
      {kLeg, kLeg}, power_function(mechanical_power_value, mechanical_power, speed), limit_on_length(-1, kShortest)};
}

Problem trot_of_lengths_and_motors(double speed) {
  return {
      {kLeg, kLeg, {5, 60, 20}, {2e-5, 1e-3, 1e-4}},
      power_function(electric_power_value, electric_power, speed),
      limit_on_length(-1, kShortest)};
}

}  // namespace design
