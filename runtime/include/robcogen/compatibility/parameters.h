// Values of parameters in the objects of the first RobCoGen, which keep kinematics parameters in the transforms and
// dynamics parameters in the inertia properties. Kernels take a cache of both.
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>

namespace robcogen::compatibility {

// For robots without parameters.
struct NoParameters {
  template <class... Values>
  void set(const Values&...) {}
  void read() {}
};

// Values that an object was given, in the order of kParameterNames, and what kernels of kinematics alone need of them.
// `Getters` are pointers to the program's own objects that provide values.
template <class Robot, class Scalar, class Getters>
struct ParameterValues {
  typename Robot::ParameterArray values = Robot::kDefaults;
  typename Robot::template Parameters<Scalar> cache{values};
  int version = 0;
  Getters getters = {};

  ParameterValues() = default;
  explicit ParameterValues(Getters g) : getters(g) { read(); }

  const Scalar* data() const { return cache.data(); }
  template <class... Values>
  void set(const Values&... from) {
    (store(from, values.data()), ...);
    cache.update(values);
    ++version;
  }
  // Takes the values of the getters, if there are any.
  void read() {
    std::apply(
        [&](const auto*... getter) {
          if ((... && getter)) set(*getter...);
        },
        getters);
  }
};

// Robots without parameters have no getters.
template <class Robot, class Scalar, class Getters>
using ParametersOf = std::conditional_t<Robot::kHasParameters, ParameterValues<Robot, Scalar, Getters>, NoParameters>;

// What the members of an object refer to. A copy of the object has members that refer to the copy: assignment keeps
// the reference.
template <class Parameters>
class ParameterReference {
 public:
  ParameterReference(const Parameters& parameters) : parameters_(&parameters) {}
  ParameterReference(const ParameterReference&) = default;
  ParameterReference& operator=(const ParameterReference&) { return *this; }
  const auto* data() const { return parameters_->data(); }

 private:
  const Parameters* parameters_;
};

// The cache for functions of kinematics and dynamics, computed again after either kind of values has changed.
template <class Robot, class Scalar, bool kHasParameters = Robot::kHasParameters>
class CombinedParameters {
 public:
  template <class Kinematics, class Dynamics>
  const CombinedParameters& of(const Kinematics& kinematics, const Dynamics& dynamics) const {
    if (kinematics.version == kinematics_ && dynamics.version == dynamics_) return *this;
    typename Robot::ParameterArray values = dynamics.values;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (Robot::kIsKinematics[i]) values[i] = kinematics.values[i];
    cache_.update(values);
    kinematics_ = kinematics.version;
    dynamics_ = dynamics.version;
    return *this;
  }
  const Scalar* data() const { return cache_.data(); }

 private:
  mutable typename Robot::template Parameters<Scalar> cache_{Robot::kDefaults};
  mutable int kinematics_ = -1, dynamics_ = -1;
};

template <class Robot, class Scalar>
class CombinedParameters<Robot, Scalar, false> {
 public:
  const CombinedParameters& of(NoParameters, NoParameters) const { return *this; }
};

}  // namespace robcogen::compatibility
