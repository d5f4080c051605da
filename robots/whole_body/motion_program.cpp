#include "motion_program.h"

#include <Eigen/Cholesky>

namespace whole_body {

// A small weight keeps accelerations that no task determines at zero.
constexpr double kSmall = 1e-6;

MotionProgram::MotionProgram(int coordinates, int held)
    : squares_(kSmall * Eigen::MatrixXd::Identity(coordinates, coordinates)),
      target_(decltype(target_)::Zero(coordinates)),
      A_(decltype(A_)::Zero(held, coordinates)),
      right_(decltype(right_)::Zero(held)),
      open_(decltype(open_)::Ones(held)) {}

void MotionProgram::add_task(double weight, const MatrixView& J, const VectorView& b) {
  squares_.noalias() += weight * J.transpose() * J;
  target_.noalias() += weight * J.transpose() * b;
}

void MotionProgram::add_task(double weight, const VectorView& b) {
  squares_.diagonal().tail(b.size()).array() += weight;
  target_.tail(b.size()) += weight * b;
}

void MotionProgram::hold(int first, const MatrixView& A, const VectorView& right) {
  A_.middleRows(first, A.rows()) = A;
  right_.segment(first, A.rows()) = right;
  open_.segment(first, A.rows()).setZero();
}

// With P = squares_: a = wanted + P^-1 A' K^-1 (right + D x - A wanted), where K = A P^-1 A', and x minimises the
// square of the term in parentheses, weighted by K^-1.
MotionProgram::Solution MotionProgram::solve(const MatrixView& D, double weight_of_x, NonnegativeVector& x) const {
  const Eigen::LLT<decltype(squares_)> squares(squares_);
  const BoundedVector<kMaxCoordinates> wanted = squares.solve(target_);
  const Bounded<kMaxCoordinates, kMaxHeld> moved = squares.solve(A_.transpose());
  Bounded<kMaxHeld, kMaxHeld> K = A_ * moved;
  K.diagonal() += open_;
  const Eigen::LDLT<decltype(K)> stiffness(K);

  const Eigen::Index forces = D.rows();
  Bounded<kMaxHeld, kMaxHeld> units = Bounded<kMaxHeld, kMaxHeld>::Identity(K.rows(), forces);
  const Bounded<kMaxHeld, kMaxHeld> weight = stiffness.solve(units);
  const Bounded<kMaxHeld, kMaxVariables> weighted = weight.topRows(forces) * D;
  NonnegativeMatrix Q = D.transpose() * weighted;
  Q.diagonal().array() += weight_of_x;
  BoundedVector<kMaxHeld> given = right_ - A_ * wanted;
  const BoundedVector<kMaxHeld> pulled = stiffness.solve(given);
  const NonnegativeVector c = -D.transpose() * pulled.head(forces);
  const int solved = minimise_nonnegative(Q, c, x);
  given.head(forces) += D * x;
  const BoundedVector<kMaxHeld> multipliers = stiffness.solve(given);
  return {wanted + moved * multipliers, solved > 0};
}

}  // namespace whole_body
