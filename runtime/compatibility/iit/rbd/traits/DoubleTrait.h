// The traits of double.
#pragma once

#include <iit/rbd/traits/ScalarTrait.h>

namespace iit::rbd {

struct DoubleTrait : ScalarTrait<double> {};

}  // namespace iit::rbd
