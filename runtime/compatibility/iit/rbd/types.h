// Types of rigid bodies by their scalar.
#pragma once

#include <iit/rbd/InertiaMatrix.h>
#include <iit/rbd/rbd.h>

namespace iit::rbd {

template <class Scalar>
using Velocity = typename Core<Scalar>::VelocityVector;
template <class Scalar>
using Force = typename Core<Scalar>::ForceVector;
template <class Scalar>
using Mat33 = typename Core<Scalar>::Matrix33;
template <class Scalar>
using Mat66 = typename Core<Scalar>::Matrix66;
template <class Scalar>
using Vec3 = typename Core<Scalar>::Vector3;
template <class Scalar>
using Vec6 = typename Core<Scalar>::Vector6;
template <class Scalar>
using InertiaMat = tpl::InertiaMatrixDense<Scalar>;

}  // namespace iit::rbd
