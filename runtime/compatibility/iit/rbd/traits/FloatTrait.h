// The traits of float.
#pragma once

#include <iit/rbd/traits/ScalarTrait.h>

namespace iit::rbd {

struct FloatTrait : ScalarTrait<float> {};

}  // namespace iit::rbd
