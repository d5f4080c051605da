// An object that is updated for a state. `Actual` derives from it and has update(state).
#pragma once

#include <iit/rbd/rbd.h>

namespace iit::rbd {

template <class State, class Actual>
class StateDependentBase {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  const Actual& operator()(const State& state) { return static_cast<Actual*>(this)->update(state); }
};

}  // namespace iit::rbd
