// The traits of a scalar. Those of other scalars than double and float have no functions; a program may specialise the
// selector for its own.
#pragma once

#include <iit/rbd/traits/DoubleTrait.h>
#include <iit/rbd/traits/FloatTrait.h>

namespace iit::rbd::tpl {

template <class SCALAR>
struct TraitSelector {
  struct Trait {
    using Scalar = SCALAR;
  };
};
template <>
struct TraitSelector<double> {
  using Trait = DoubleTrait;
};
template <>
struct TraitSelector<float> {
  using Trait = FloatTrait;
};

}  // namespace iit::rbd::tpl
