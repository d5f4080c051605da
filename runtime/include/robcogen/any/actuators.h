// Lengths, rates and lever arms of the actuators of robots that a program picks at run time (any_robot.h). Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include "robcogen/any/robot.h"

namespace robcogen {

inline void AnyRobot::actuator_lengths(In q, Out lengths) const {
  constexpr const char* kFunction = "actuator_lengths";
  const reflection::MatrixKernel& kernel = tables_->actuator_kernels.lengths;
  expect_kernel(kFunction, kernel);
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "lengths", lengths.size(), tables_->actuators.size);
  kernel(functions_->cache(), q.data(), lengths.data());
}

inline void AnyRobot::actuator_velocities(In q, In v, Out velocities) const {
  constexpr const char* kFunction = "actuator_velocities";
  const reflection::RateKernel& kernel = tables_->actuator_kernels.velocities;
  expect_kernel(kFunction, kernel);
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "v", v.size(), size());
  expect(kFunction, "velocities", velocities.size(), tables_->actuators.size);
  kernel(functions_->cache(), q.data(), v.data() + (size() - dof()), velocities.data());
}

inline void AnyRobot::actuator_jacobian(In q, OutMatrix J) const {
  constexpr const char* kFunction = "actuator_jacobian";
  const reflection::MatrixKernel& kernel = tables_->actuator_kernels.jacobian;
  expect_kernel(kFunction, kernel);
  const int actuators = tables_->actuators.size;
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "a column of J", J.rows(), actuators);
  expect(kFunction, "a row of J", J.cols(), dof());
  if (J.outerStride() != actuators)
    throw std::invalid_argument("actuator_jacobian: the columns of J must be contiguous");
  kernel(functions_->cache(), q.data(), J.data());
}

}  // namespace robcogen

#else
#error "robcogen/any/actuators.h needs C++20: compile with -std=c++20"
#endif
