// The self-check of one generated library: over random states, against the independent reference and against
// identities that hold for every robot. Compiled once a robot, with
//     ROBCOGEN_ROBOT_HEADER, ROBCOGEN_REFLECTION_HEADER   the generated headers, as <…>
//     ROBCOGEN_ROBOT_NAMESPACE                            the namespace of the generated code
//     ROBCOGEN_HAS_<GROUP>                                1 where the library has the group, else 0
//
//     hyl_selfcheck [--seed N] [--samples N]
//
// prints one line a check and exits with 1 when one failed, 2 when the command line is wrong.
#include <cstdlib>
#include <cstring>

#include ROBCOGEN_ROBOT_HEADER
#include ROBCOGEN_REFLECTION_HEADER

#include "robcogen/reference/check_dynamics.h"
#include "robcogen/reference/check_kinematics.h"

namespace robcogen::reference {
namespace {

constexpr bool kHasInverseDynamics = ROBCOGEN_HAS_INVERSE_DYNAMICS;
constexpr bool kHasBiasForces = ROBCOGEN_HAS_BIAS_FORCES;
constexpr bool kHasForwardDynamics = ROBCOGEN_HAS_FORWARD_DYNAMICS;
constexpr bool kHasInertia = ROBCOGEN_HAS_JOINT_SPACE_INERTIA;

template <class R>
Checks selfcheck(const Robot& robot, std::uint64_t seed, int samples) {
  Checks checks;
  std::mt19937_64 engine(seed);
  for (int sample = 0; sample < samples; ++sample) {
    const Sample s = random_sample(engine, robot);
    const Expected e(robot, s);
    if constexpr (kHasInverseDynamics) check_inverse_dynamics<R>(robot, s, e, sample, checks);
    if constexpr (kHasBiasForces) check_bias_forces<R>(robot, s, e, sample, checks);
    if constexpr (kHasBiasForces) check_gravity_gradient<R>(robot, s, e, sample, checks);
    if constexpr (kHasForwardDynamics) check_forward_dynamics<R>(robot, s, e, sample, checks);
    if constexpr (kHasForwardDynamics && kHasInverseDynamics) check_round_trips<R>(robot, s, e, sample, checks);
    if constexpr (kHasInertia) check_inertia_matrix<R>(robot, s, e, sample, checks);
    if constexpr (kHasInertia && kHasInverseDynamics) check_inertia_columns<R>(s, e, sample, checks);
    if constexpr (kHasInertia && kHasBiasForces) check_power<R>(s, sample, checks);
    // The tables are empty where the library has no transforms or no Jacobians.
    check_transforms(robot, s, sample, checks);
    check_jacobians(robot, s, sample, checks);
  }
  return checks;
}

}  // namespace
}  // namespace robcogen::reference

int main(int argc, char** argv) {
  namespace generated = ROBCOGEN_ROBOT_NAMESPACE;
  std::uint64_t seed = 1;
  int samples = 20;
  for (int i = 1; i < argc; i += 2) {
    char* end = nullptr;
    const bool has_value = i + 1 < argc;
    if (has_value && std::strcmp(argv[i], "--seed") == 0) seed = std::strtoull(argv[i + 1], &end, 10);
    if (has_value && std::strcmp(argv[i], "--samples") == 0)
      samples = static_cast<int>(std::strtol(argv[i + 1], &end, 10));
    if (end == nullptr || end == argv[i + 1] || *end != '\0' || samples < 1) {
      std::fprintf(stderr, "usage: %s [--seed N] [--samples N]\n", argv[0]);
      return 2;
    }
  }
  const robcogen::reflection::Robot& robot = generated::reflection::robot;
  std::printf("%s: seed %llu, %d samples\n", robot.name, static_cast<unsigned long long>(seed), samples);
  const robcogen::reference::Checks checks = robcogen::reference::selfcheck<generated::Robot>(robot, seed, samples);
  const int failures = checks.print();
  std::printf("%d checks, %d failed\n", checks.size(), failures);
  return failures == 0 ? 0 : 1;
}
