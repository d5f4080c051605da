// With a floating base gravity expresses the orientation of the base, so every function requires it, whatever its other
// arguments are.
#include "robots.h"

#if __has_include(<quadruped/batch.h>)
#include <quadruped/batch.h>
#endif

namespace robcogen::test::gravity_test {
namespace {

// True if the function can be called with these arguments.
template <class R, class... Arguments>
constexpr bool kInverse = requires(const R& robot, const Arguments&... a) {
  robot.inverse_dynamics(a...);
};
template <class R, class... Arguments>
constexpr bool kActuated = requires(const R& robot, const Arguments&... a) {
  robot.inverse_dynamics_fully_actuated(a...);
};
template <class R, class... Arguments>
constexpr bool kForward = requires(const R& robot, const Arguments&... a) {
  robot.forward_dynamics(a...);
};
template <class R, class... Arguments>
constexpr bool kBias = requires(const R& robot, const Arguments&... a) {
  robot.bias_forces(a...);
};
template <class R, class... Arguments>
constexpr bool kGravityForces = requires(const R& robot, const Arguments&... a) {
  robot.gravity_forces(a...);
};
template <class R, class... Arguments>
constexpr bool kPotential = requires(const R& robot, const Arguments&... a) {
  robot.potential_energy(a...);
};

// Returns how many functions can be called with these loads, with positions or with their sines and cosines.
template <class R, class Positions, class... Loads>
constexpr int callable() {
  using State = typename R::JointState;
  using Twist = typename R::Twist;
  using Acceleration = typename R::SpatialAcceleration;
  if constexpr (R::kFloatingBase) {
    return kInverse<R, Positions, State, State, Twist, Loads...> +
           kActuated<R, Positions, State, State, Twist, Acceleration, Loads...> +
           kForward<R, Positions, State, State, Twist, Loads...> + kBias<R, Positions, State, Twist, Loads...> +
           kGravityForces<R, Positions, Loads...> + kPotential<R, Positions, Loads...>;
  } else {
    return kInverse<R, Positions, State, State, Loads...> + kForward<R, Positions, State, State, Loads...> +
           kBias<R, Positions, State, Loads...> + kGravityForces<R, Positions, Loads...> +
           kPotential<R, Positions, Loads...>;
  }
}

template <class R>
class Gravities : public ::testing::Test {};
#if ROBCOGEN_TEST_EVERYTHING
using Robots = ::testing::Types<hyl::Robot, hyl::f32::Robot, quadruped::Robot, quadruped::f32::Robot, torso::Robot>;
#else
using Robots = ::testing::Types<hyl::Robot, quadruped::f32::Robot>;
#endif
TYPED_TEST_SUITE(Gravities, Robots);

TYPED_TEST(Gravities, AreAskedForWhereTheBaseFloats) {
  using R = TypeParam;
  using State = typename R::JointState;
  using At = typename R::JointTrigonometry;
  using Gravity = typename R::Gravity;
  using Wrenches = typename R::LinkWrenches;
  constexpr bool floats = R::kFloatingBase;
  constexpr int all = floats ? 6 : 5, take_wrenches = floats ? 4 : 3;
  EXPECT_EQ((callable<R, State>()), floats ? 0 : all);
  EXPECT_EQ((callable<R, At>()), floats ? 0 : all);
  EXPECT_EQ((callable<R, State, Wrenches>()), floats ? 0 : take_wrenches);
  EXPECT_EQ((callable<R, State, Gravity>()), all);
  EXPECT_EQ((callable<R, At, Gravity>()), all);
  EXPECT_EQ((callable<R, State, Gravity, Wrenches>()), take_wrenches);
}

#if __has_include(<quadruped/batch.h>)
template <class... Arguments>
constexpr bool kManyGravityForces = requires(const Arguments&... a) {
  quadruped::batch::gravity_forces(a...);
};

TEST(ManyStates, TakeGravityWhereTheBaseFloats) {
  using Joints = batch::Input<quadruped::JointState>;
  using Forces = batch::Output<quadruped::JointState>;
  using Wrenches = batch::Output<Wrench>;
  EXPECT_TRUE((kManyGravityForces<std::ptrdiff_t, Joints, Gravity, Forces, Wrenches>));
  EXPECT_FALSE((kManyGravityForces<std::ptrdiff_t, Joints, Forces, Wrenches>));
}
#endif

}  // namespace
}  // namespace robcogen::test::gravity_test
