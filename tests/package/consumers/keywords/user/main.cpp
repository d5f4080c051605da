// At rest, the forces with an acceleration minus those without it equal the inertia matrix times the acceleration.
#include <walker/legs/left_leg/batch.h>
#include <walker/legs/left_leg/left_leg.h>
#include <right_leg/right_leg.h>

int main() {
  const right_leg::JointState q(0.1, 0.4, -0.9);
  const right_leg::JointState rest = right_leg::JointState::Zero();
  const right_leg::JointState qdd(1.0, 2.0, -3.0);
  const right_leg::JointState tau =
      right_leg::inverse_dynamics(q, rest, qdd) - right_leg::inverse_dynamics(q, rest, rest);
  if ((walker::legs::left_leg::joint_space_inertia(q) * qdd - tau).norm() > 1e-9) return 1;

  // The same for a batch of two states.
  const right_leg::JointState states[] = {rest, q};
  walker::legs::left_leg::InertiaMatrix matrices[2];
  walker::legs::left_leg::batch::joint_space_inertia(
      2, robcogen::batch::by_state(states), robcogen::batch::by_state(matrices));
  return (matrices[1] * qdd - tau).norm() < 1e-9 ? 0 : 1;
}
