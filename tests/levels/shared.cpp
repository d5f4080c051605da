// A robot's library within a shared library.
#include <puma560/puma560.h>

extern "C" void puma560_joint_forces(const double* q, double* tau) {
  using Vector = puma560::JointState;
  Eigen::Map<Vector>(tau, puma560::kDof) =
      puma560::inverse_dynamics(Eigen::Map<const Vector>(q, puma560::kDof), Vector::Ones(), Vector::Ones());
}
