// The traits of a scalar.
#pragma once

#include <iit/rbd/traits/DoubleTrait.h>
#include <iit/rbd/traits/FloatTrait.h>

namespace iit::rbd::tpl {

template <class Scalar>
struct TraitSelector {};
template <>
struct TraitSelector<double> {
  using Trait = DoubleTrait;
};
template <>
struct TraitSelector<float> {
  using Trait = FloatTrait;
};

}  // namespace iit::rbd::tpl
