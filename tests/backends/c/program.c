/* A program in C that uses a robot and transforms without one. */
#include <euler_in_c_c/euler_in_c_c.h>
#include <in_c_hyl_c/in_c_hyl_c.h>
#include <math.h>
#include <stdio.h>

int main(void) {
  const double q[in_c_hyl_dof] = {0.64, -0.65, 1.34}, rest[in_c_hyl_dof] = {0.0, 0.0, 0.0};
  double tau[in_c_hyl_dof], X[16];
  const double turn[3] = {0.1, 0.2, 0.3};
  int i;
  in_c_hyl_inverse_dynamics(q, rest, rest, tau);
  for (i = 0; in_c_hyl_joint_names[i]; ++i) printf("%s %g\n", in_c_hyl_joint_names[i], tau[i]);
  /* The slider carries the whole weight, 7.501 kg. */
  if (i != in_c_hyl_dof || fabs(tau[0] - 7.501 * 9.81) > 1e-9) return 1;
  euler_in_c_homogeneous_S_X_zyx(turn, X);
  /* The first column of the rotation has unit length. */
  return fabs(X[0] * X[0] + X[1] * X[1] + X[2] * X[2] - 1.0) < 1e-12 ? 0 : 2;
}
