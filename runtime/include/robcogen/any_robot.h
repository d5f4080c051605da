// A robot that a program picks at run time: one type for all generated libraries, fixed and floating base. Needs C++20.
//
//     #include <hyl/hyl.h>
//     #include <hyl/reflection.h>
//     const robcogen::AnyRobot robot = robcogen::make_any<hyl::Robot>(hyl::reflection::robot);
//     robot.inverse_dynamics(q, v, qdd, tau);
//
// Positions q have position_count() elements (positions.h: more than dof() with spherical joints), joint forces tau
// have dof() elements. Velocities v, accelerations a and generalised forces f have size() elements: with a floating
// base, its twist, spatial acceleration or wrench (angular first, base coordinates), then the joints; otherwise only
// the joints. All units are SI.
//
// Gravity (m/s^2) is in base coordinates. With a fixed base it may be omitted: the default is standard gravity. With a
// floating base it encodes the orientation of the base, and without it std::invalid_argument is thrown.
//
// The size of every argument is checked, and std::invalid_argument names the one that is wrong.
// Nothing else throws, and nothing allocates after construction, as long as arguments are vectors or contiguous parts
// of them: Eigen evaluates expressions such as q + dq, and rows of matrices, into memory of its own. A call costs a
// virtual call and copies of the arguments. Copies of an AnyRobot share their content, which never changes; any number
// of threads may use one.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include "robcogen/any/actuators.h"
#include "robcogen/any/dynamics.h"
#include "robcogen/any/frames.h"

namespace robcogen {

// The robot of a library: hyl::Robot with hyl::reflection::robot. One with parameters carries their values.
template <class R>
AnyRobot make_any(const reflection::Robot& tables, const R& robot = R()) {
  return AnyRobot(robot, tables);
}

}  // namespace robcogen

#else
#error "robcogen/any_robot.h needs C++20: compile with -std=c++20"
#endif
