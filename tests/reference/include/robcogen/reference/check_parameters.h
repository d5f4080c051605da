// Checks of a robot's parameters after updates of some of them, and after copies.
#pragma once

#include <algorithm>

#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/compiled_robot.h"
#include "robcogen/reference/parameters.h"

namespace robcogen::reference {

template <class R>
typename R::Parameters parameters_of(const std::vector<double>& values) {
  typename R::ParameterArray array;
  std::copy(values.begin(), values.end(), array.begin());
  return typename R::Parameters(array);
}

// The number of cached quantities that differ.
template <class Parameters>
Real differences(const Parameters& a, const Parameters& b) {
  int count = 0;
  for (std::size_t i = 0; i < Parameters::size(); ++i) count += a.data()[i] == b.data()[i] ? 0 : 1;
  return count;
}

// Returns `after` for the parameters of one interface, and `before` for the others.
inline std::vector<double> updated(
    const Robot& robot,
    const std::vector<double>& after,
    std::vector<double> before,
    bool dynamics) {
  for (int i = 0; i < robot.parameters.size; ++i) {
    const reflection::Parameter& p = robot.parameters[i];
    const auto k = static_cast<std::size_t>(i);
    if (p.shared || p.dynamics == dynamics) before[k] = after[k];
  }
  return before;
}

// Updates from values `before` to values `after`, at once and in steps.
template <class R>
void check_updates(
    const Robot& robot,
    const std::vector<double>& after,
    const std::vector<double>& before,
    Checks& checks,
    int sample) {
  using Parameters = typename R::Parameters;
  const Parameters start = parameters_of<R>(before), wanted = parameters_of<R>(after);
  const auto values = wanted.values(), old = start.values();
  const auto record = [&](const char* what, const Parameters& found, const Parameters& expected) {
    checks.record(what, kExact, differences(found, expected), sample);
  };
  Parameters p = start;
  p.update(values, values);
  record("parameters: update", p, wanted);

  for (const bool kinematics_first : {true, false}) {
    p = start;
    if (kinematics_first) {
      p.update(static_cast<const typename R::KinematicsParameters&>(values));
      record("parameters: update of kinematics", p, parameters_of<R>(updated(robot, after, before, false)));
      p.update(static_cast<const typename R::DynamicsParameters&>(values));
    } else {
      p.update(static_cast<const typename R::DynamicsParameters&>(values));
      record("parameters: update of dynamics", p, parameters_of<R>(updated(robot, after, before, true)));
      p.update(static_cast<const typename R::KinematicsParameters&>(values));
    }
    record("parameters: updates of both kinds", p, wanted);
  }

  Parameters copy = start;
  copy.update(values);
  record("parameters: update of a copy", copy, wanted);
  record("parameters: original of an updated copy", start, Parameters(old));
}

}  // namespace robcogen::reference
