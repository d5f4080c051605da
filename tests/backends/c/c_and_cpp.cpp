// The C library and the C++ library give the same results.
#include <both/leg/leg.h>
#include <both_leg_c/both_leg_c.h>

#include <cstdio>
#include <cstring>

int main() {
  using namespace both::leg;
  double worst = 0;
  for (int state = 0; state < 100; ++state) {
    const JointState q = JointState::Random() * 3, qd = JointState::Random(), qdd = JointState::Random();
    JointState tau;
    both_leg_inverse_dynamics(q.data(), qd.data(), qdd.data(), tau.data());
    InertiaMatrix H;
    both_leg_joint_space_inertia(q.data(), H.data());
    auto J = jacobians::fr_base_J_fr_foot(q);
    const auto expected = J;
    both_leg_fr_base_J_fr_foot(q.data(), J.data());
    worst = std::max(
        {worst, (tau - inverse_dynamics(q, qd, qdd)).norm(), (H - joint_space_inertia(q)).norm(),
         (J - expected).norm()});
    const Eigen::Matrix<float, 3, 1> qf = q.cast<float>(), qdf = qd.cast<float>(), qddf = qdd.cast<float>();
    Eigen::Matrix<float, 3, 1> tauf;
    both_leg_inverse_dynamicsf(qf.data(), qdf.data(), qddf.data(), tauf.data());
    if ((tauf.cast<double>() - tau).norm() > 1e-4 * (1 + tau.norm())) return 2;
  }
  const bool names =
      both_leg_dof == kDof && std::strcmp(both_leg_joint_names[2], "KFE") == 0 && !both_leg_joint_names[3];
  std::printf("largest difference %g\n", worst);
  return worst < 1e-12 && names ? 0 : 1;
}
