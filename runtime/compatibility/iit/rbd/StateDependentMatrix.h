// A matrix that is updated for a state, and keeps its value until it is updated again.
#pragma once

#include <iit/rbd/StateDependentBase.h>
#include <iit/rbd/rbd.h>

namespace iit::rbd {

template <class State, int kRows, int kColumns, class Actual>
class StateDependentMatrix : public StateDependentBase<State, Actual>,
                             public PlainMatrix<typename State::Scalar, kRows, kColumns> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using MatrixType = PlainMatrix<typename State::Scalar, kRows, kColumns>;
  using Scalar = typename MatrixType::Scalar;
  using Index = typename MatrixType::Index;

  template <class Other>
  StateDependentMatrix& operator=(const MatrixBase<Other>& other) {
    MatrixType::operator=(other);
    return *this;
  }

  using StateDependentBase<State, Actual>::operator();
  using MatrixType::operator();
};

}  // namespace iit::rbd
