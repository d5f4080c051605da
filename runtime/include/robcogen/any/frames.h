// Transforms and Jacobians of robots that a program picks at run time (any_robot.h). Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include "robcogen/any/robot.h"

namespace robcogen {

inline Matrix<double, 4, 4> AnyRobot::homogeneous_transform(int transform, In q) const {
  return of_kernel<4>("homogeneous_transform", transform, q, [](const auto& t) { return t.homogeneous; });
}

inline Matrix<double, 6, 6> AnyRobot::motion_transform(int transform, In q) const {
  return of_kernel<6>("motion_transform", transform, q, [](const auto& t) { return t.motion; });
}

inline Matrix<double, 6, 6> AnyRobot::force_transform(int transform, In q) const {
  return of_kernel<6>("force_transform", transform, q, [](const auto& t) { return t.force; });
}

inline void AnyRobot::jacobian(int jacobian, In q, OutMatrix J) const {
  constexpr const char* kFunction = "jacobian";
  expect_index(kFunction, jacobian, tables_->jacobians.size);
  const reflection::Jacobian& table = tables_->jacobians[jacobian];
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "a column of J", J.rows(), 6);
  expect(kFunction, "a row of J", J.cols(), table.column_count);
  if (J.outerStride() != 6) throw std::invalid_argument("jacobian: the columns of J must be contiguous");
  table.kernel(functions_->cache(), q.data(), J.data());
}

}  // namespace robcogen

#else
#error "robcogen/any/frames.h needs C++20: compile with -std=c++20"
#endif
