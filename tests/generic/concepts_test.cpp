// Which libraries satisfy which concepts.
#include <generic_lean/generic_lean.h>

#include "robots.h"

namespace robcogen::test::concepts_test {
namespace {

static_assert(FixedBaseRobot<hyl::Robot> && FixedBaseRobot<puma560::Robot>);
static_assert(FloatingBaseRobot<quadruped::Robot> && FloatingBaseRobot<torso::Robot>);
static_assert(!FloatingBaseRobot<hyl::Robot> && !FixedBaseRobot<quadruped::Robot>);
static_assert(HasJointSpaceInertiaFactor<hyl::Robot> && HasJointSpaceInertiaFactor<quadruped::f32::Robot>);
static_assert(HasEnergy<hyl::Robot> && HasEnergy<quadruped::Robot>);
static_assert(HasCentroidal<hyl::Robot> && HasCentroidal<quadruped::Robot>);

// In single precision too.
static_assert(FixedBaseRobot<hyl::f32::Robot> && FloatingBaseRobot<quadruped::f32::Robot>);

// A library with fewer algorithms satisfies only their concepts.
static_assert(RobotTraits<generic_lean::Robot> && FixedBase<generic_lean::Robot>);
static_assert(HasInverseDynamics<generic_lean::Robot> && HasEnergy<generic_lean::Robot>);
static_assert(!HasForwardDynamics<generic_lean::Robot> && !HasJointSpaceInertia<generic_lean::Robot>);
static_assert(!HasJointSpaceInertiaFactor<generic_lean::Robot>);
static_assert(!HasBiasForces<generic_lean::Robot> && !HasCentroidal<generic_lean::Robot>);
static_assert(!FixedBaseRobot<generic_lean::Robot>);

// Types that are not robots.
static_assert(!RobotTraits<int> && !RobotTraits<hyl::JointState>);

// A function that may throw does not satisfy the concept, which is for control loops; nor does one with another result
// type.
struct Throwing : hyl::Robot {
  static JointState inverse_dynamics(const JointState& q, const JointState&, const JointState&) { return q; }
};
struct Integral : hyl::Robot {
  static int joint_space_inertia(const JointState&) noexcept { return 0; }
};
static_assert(RobotTraits<Throwing> && !HasInverseDynamics<Throwing>);
static_assert(HasInverseDynamics<Integral> && !HasJointSpaceInertia<Integral>);

// Functions of a robot that holds data need not be static.
struct Carrying : hyl::Robot {
  double mass = 1;
  InertiaMatrix joint_space_inertia(const JointState& q) const noexcept { return mass * hyl::joint_space_inertia(q); }
};
static_assert(FixedBaseRobot<Carrying>);

template <FixedBaseRobot R>
const char* base() {
  return "fixed";
}
template <FloatingBaseRobot R>
const char* base() {
  return "floating";
}

TEST(Concepts, ChooseAmongOverloads) {
  EXPECT_STREQ(base<hyl::Robot>(), "fixed");
  EXPECT_STREQ(base<torso::Robot>(), "floating");
}

}  // namespace
}  // namespace robcogen::test::concepts_test
