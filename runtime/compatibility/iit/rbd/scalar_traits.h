// The traits of scalars, by the names that they have in version 5.
#pragma once

#include <iit/rbd/traits/DoubleTrait.h>
#include <iit/rbd/traits/FloatTrait.h>

namespace iit::rbd {

using DoubleTraits = DoubleTrait;
using FloatTraits = FloatTrait;

}  // namespace iit::rbd
