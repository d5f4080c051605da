// Bases of coordinate transforms and Jacobians.
#pragma once

#include <iit/rbd/StateDependentMatrix.h>

namespace iit::rbd {

template <class State, class Actual>
class RotationTransformBase : public StateDependentMatrix<State, 3, 3, Actual> {};

template <class State, class Actual>
class HomogeneousTransformBase : public StateDependentMatrix<State, 4, 4, Actual> {};

template <class State, class Actual>
class SpatialTransformBase : public StateDependentMatrix<State, 6, 6, Actual> {};

template <class State, int kColumns, class Actual>
class JacobianBase : public StateDependentMatrix<State, 6, kColumns, Actual> {};

}  // namespace iit::rbd
