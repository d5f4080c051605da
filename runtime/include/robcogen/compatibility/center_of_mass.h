// getWholeBodyCOM of the first RobCoGen.
#pragma once

#include "robcogen/compatibility/iit.h"
#include "robcogen/compatibility/parameters.h"

namespace robcogen::compatibility {

// The centre of mass in base coordinates, in the state of the transforms.
template <class Trait, class Robot, class Inertias, class Transforms>
typename iit::rbd::Core<typename Trait::Scalar>::Vector3 center_of_mass(
    const Inertias& inertias,
    const Transforms& transforms) {
  using Scalar = typename Trait::Scalar;
  typename iit::rbd::Core<Scalar>::Vector3 com;
  const CombinedParameters<Robot, Scalar> combined;
  call<Robot>(
      Robot::template center_of_mass<Scalar>, combined.of(transforms.parameters(), inertias.parameters()),
      transforms.state().data(), com.data());
  return com;
}

}  // namespace robcogen::compatibility
