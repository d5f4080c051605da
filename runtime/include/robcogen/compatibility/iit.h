// The runtime <iit/rbd/…> that programs for the first RobCoGen include, in any of its versions, and what the classes of
// this folder need of it. A program has it already; the CMake keyword COMPATIBILITY_RUNTIME provides ours.
#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <type_traits>

#include <iit/rbd/rbd.h>

#include <iit/rbd/InertiaMatrix.h>
#include <iit/rbd/StateDependentMatrix.h>
#include <iit/rbd/TransformsBase.h>
#include <iit/rbd/utils.h>

#if __has_include(<iit/rbd/traits/TraitSelector.h>)
#include <iit/rbd/traits/TraitSelector.h>
#elif __has_include(<iit/rbd/scalar_traits.h>)
#include <iit/rbd/scalar_traits.h>
#endif

namespace robcogen::compatibility {

#if __has_include(<iit/rbd/traits/TraitSelector.h>)

template <class Scalar>
using TraitOf = typename iit::rbd::tpl::TraitSelector<Scalar>::Trait;

#else

// Versions of the runtime without a selector of traits have traits of double only.
template <class Kind>
struct TraitSelector {
  struct Trait {
    using Scalar = Kind;
  };
};

#if __has_include(<iit/rbd/scalar_traits.h>)
template <>
struct TraitSelector<double> {
  using Trait = iit::rbd::DoubleTraits;
};
#endif

template <class Scalar>
using TraitOf = typename TraitSelector<Scalar>::Trait;

#endif

using DoubleTrait = TraitOf<double>;

template <class Scalar>
using InertiaMatrix = iit::rbd::tpl::InertiaMatrixDense<Scalar>;

// One value for each joint.
template <class Robot, class Scalar>
using JointState = iit::rbd::PlainMatrix<Scalar, Robot::kJoints, 1>;

// Stands for a function that the robot does not have.
struct Absent {};

// Calls a kernel. Those of robots with parameters take them first.
template <class Robot, class Kernel, class Parameters, class... Arrays>
void call(Kernel kernel, [[maybe_unused]] const Parameters& parameters, Arrays... arrays) {
  if constexpr (std::is_same<Kernel, Absent>::value)
    static_assert(
        !std::is_same<Kernel, Absent>::value,
        "this robot does not have the function: robcogen ops MODEL lists those that it has, with the reasons");
  else if constexpr (Robot::kHasParameters)
    kernel(parameters.data(), arrays...);
  else
    kernel(arrays...);
}

}  // namespace robcogen::compatibility
