// AnyRobot returns the results of the library, reports wrong arguments, and does not allocate.
#include "robcogen/any_robot.h"

#include <hyl_parametric/hyl_parametric.h>
#include <hyl_parametric/reflection.h>

#include <vector>

#include "allocation_hook.h"
#include "message_of.h"
#include "robots.h"

namespace robcogen::test::any_robot_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct HylParametric {
  using Robot = hyl_parametric::Robot;
  static const reflection::Robot& tables() { return hyl_parametric::reflection::robot; }
};

template <class Case>
class Any : public ::testing::Test {};
#if ROBCOGEN_TEST_EVERYTHING
using Robots = ::testing::Types<Hyl, Puma560, Quadruped, Torso, HylParametric>;
#else
using Robots = ::testing::Types<Torso, HylParametric>;
#endif
TYPED_TEST_SUITE(Any, Robots);

VectorXd random_vector(std::mt19937_64& engine, int size) {
  VectorXd v(size);
  for (double& x : v) x = reference::uniform(engine, 2);
  return v;
}

// Arguments of one call, in the types of AnyRobot and of the library.
template <class R>
struct Arguments {
  explicit Arguments(const AnyRobot& robot, std::mt19937_64& engine)
      : q(random_vector(engine, robot.dof())),
        v(random_vector(engine, robot.size())),
        a(random_vector(engine, robot.size())),
        tau(random_vector(engine, robot.dof())),
        gravity(random_vector(engine, 3)),
        external(R::kLinkCount) {
    for (int i = 0; i < R::kLinkCount; ++i)
      wrenches[i] = external[static_cast<std::size_t>(i)] = Wrench(random_vector(engine, 6));
  }
  typename R::JointState qd() const { return v.tail(R::kDof); }
  typename R::JointState qdd() const { return a.tail(R::kDof); }
  Twist base_velocity() const { return Twist(v.head<6>()); }
  SpatialAcceleration base_acceleration() const { return SpatialAcceleration(a.head<6>()); }

  VectorXd q, v, a, tau;
  Gravity gravity;
  std::vector<Wrench> external;
  typename R::LinkWrenches wrenches;
};

template <class R, class Forces>
VectorXd stacked([[maybe_unused]] const Forces& forces) {
  VectorXd result(R::kDof + (R::kFloatingBase ? 6 : 0));
  if constexpr (R::kFloatingBase) {
    result << forces.base_wrench.vector(), forces.tau;
  } else {
    result << forces;
  }
  return result;
}

TYPED_TEST(Any, GivesWhatTheLibraryGives) {
  using R = typename TypeParam::Robot;
  const R direct;
  const AnyRobot robot = make_any<R>(TypeParam::tables());
  EXPECT_EQ(robot.dof(), R::kDof);
  EXPECT_EQ(robot.floating_base(), R::kFloatingBase);
  EXPECT_STREQ(robot.name(), TypeParam::tables().name);
  std::mt19937_64 engine(5);
  const Arguments<R> x(robot, engine);
  VectorXd tau(robot.dof()), a(robot.size()), f(robot.size());
  MatrixXd H(robot.size(), robot.size());

  // With all arguments.
  const SpatialAcceleration base = robot.inverse_dynamics(x.q, x.v, x.a.tail(R::kDof), tau, x.gravity, x.external);
  robot.inverse_dynamics_fully_actuated(x.q, x.v, x.a, f, x.gravity, x.external);
  robot.forward_dynamics(x.q, x.v, x.tau, a, x.gravity, x.external);
  if constexpr (R::kFloatingBase) {
    const auto inverse = direct.inverse_dynamics(x.q, x.qd(), x.qdd(), x.base_velocity(), x.gravity, x.wrenches);
    EXPECT_EQ(tau, inverse.tau);
    EXPECT_EQ(base, inverse.base_acceleration);
    EXPECT_EQ(
        f, stacked<R>(direct.inverse_dynamics_fully_actuated(
               x.q, x.qd(), x.qdd(), x.base_velocity(), x.base_acceleration(), x.gravity, x.wrenches)));
    const auto forward = direct.forward_dynamics(x.q, x.qd(), x.tau, x.base_velocity(), x.gravity, x.wrenches);
    EXPECT_EQ(a.template head<6>(), forward.base_acceleration.vector());
    EXPECT_EQ(a.tail(R::kDof), forward.qdd);
  } else {
    EXPECT_EQ(tau, direct.inverse_dynamics(x.q, x.qd(), x.qdd(), x.gravity, x.wrenches));
    EXPECT_EQ(base, SpatialAcceleration());
    EXPECT_EQ(f, tau);
    EXPECT_EQ(a, direct.forward_dynamics(x.q, x.qd(), x.tau, x.gravity, x.wrenches));
  }
  const auto with_velocity = [&](const auto& function) {
    if constexpr (R::kFloatingBase) {
      return stacked<R>(function(x.q, x.qd(), x.base_velocity()));
    } else {
      return stacked<R>(function(x.q, x.qd()));
    }
  };
  // Without the optional arguments: no external wrenches, and standard gravity with a fixed base.
  if constexpr (R::kFloatingBase)
    robot.bias_forces(x.q, x.v, f, kStandardGravity);
  else
    robot.bias_forces(x.q, x.v, f);
  EXPECT_EQ(f, with_velocity([&](const auto&... s) { return direct.bias_forces(s..., Gravity::standard()); }));
  robot.bias_forces(x.q, x.v, f, x.gravity, x.external);
  EXPECT_EQ(f, with_velocity([&](const auto&... s) { return direct.bias_forces(s..., x.gravity, x.wrenches); }));
  robot.gravity_forces(x.q, f, x.gravity);
  EXPECT_EQ(f, stacked<R>(direct.gravity_forces(x.q, x.gravity)));
  robot.coriolis_forces(x.q, x.v, f);
  EXPECT_EQ(f, with_velocity([&](const auto&... s) { return direct.coriolis_forces(s...); }));
  robot.joint_space_inertia(x.q, H);
  EXPECT_EQ(H, direct.joint_space_inertia(x.q));
}

TYPED_TEST(Any, DoesNotAllocate) {
  using R = typename TypeParam::Robot;
  const AnyRobot robot = make_any<R>(TypeParam::tables());
  std::mt19937_64 engine(6);
  const Arguments<R> x(robot, engine);
  const VectorXd qdd = x.a.tail(R::kDof);
  VectorXd tau(robot.dof()), a(robot.size()), f(robot.size());
  MatrixXd H(robot.size(), robot.size()), J(6, TypeParam::tables().jacobians[0].column_count);
  Eigen::Matrix4d X;
  {
    const NoAllocation during("AnyRobot");
    const AnyRobot copy = robot;
    copy.inverse_dynamics(x.q, x.v, qdd, tau, x.gravity, x.external);
    copy.inverse_dynamics(x.q, x.v, x.a.tail(R::kDof), tau, x.gravity);  // a part that is contiguous
    copy.inverse_dynamics_fully_actuated(x.q, x.v, x.a, f, x.gravity, x.external);
    copy.forward_dynamics(x.q, x.v, x.tau, a, x.gravity, x.external);
    copy.bias_forces(x.q, x.v, f, x.gravity);
    copy.gravity_forces(x.q, f, x.gravity);
    if constexpr (!R::kFloatingBase) copy.gravity_forces(x.q, f);
    copy.coriolis_forces(x.q, x.v, f);
    copy.joint_space_inertia(x.q, H);
    X = copy.homogeneous_transform(0, x.q);
    copy.motion_transform(0, x.q);
    copy.force_transform(0, x.q);
    copy.jacobian(0, x.q, J);
  }
  EXPECT_TRUE(X.allFinite() && J.allFinite());
}

TEST(AnyRobot, SaysWhichArgumentHasTheWrongSize) {
  const AnyRobot leg = make_any<hyl::Robot>(hyl::reflection::robot);
  const AnyRobot quadruped = make_any<quadruped::Robot>(quadruped::reflection::robot);
  const VectorXd three = VectorXd::Zero(3), four = VectorXd::Zero(4), twelve = VectorXd::Zero(12);
  VectorXd out = VectorXd::Zero(3);
  EXPECT_EQ(
      message_of([&] { leg.inverse_dynamics(four, three, three, out); }),
      "inverse_dynamics of HyL: q has 4 elements and must have 3");
  EXPECT_EQ(
      message_of([&] { leg.inverse_dynamics(three, three, three, out, kStandardGravity, std::vector<Wrench>(3)); }),
      "inverse_dynamics of HyL: external has 3 elements and must have 4");
  // The velocity includes that of the base.
  EXPECT_EQ(
      message_of([&] { quadruped.coriolis_forces(twelve, twelve, out); }),
      "coriolis_forces of Quadruped: v has 12 elements and must have 18");
  EXPECT_EQ(
      message_of([&] { leg.bias_forces(three, three, out.head(2)); }),
      "bias_forces of HyL: f has 2 elements and must have 3");
  MatrixXd H(3, 2);
  EXPECT_EQ(
      message_of([&] { leg.joint_space_inertia(three, H); }),
      "joint_space_inertia of HyL: a row of H has 2 elements and must have 3");
  EXPECT_EQ(
      message_of([&] { leg.homogeneous_transform(100, three); }),
      "homogeneous_transform of HyL: index 100 is out of range");
  EXPECT_EQ(message_of([&] { leg.jacobian(-1, three, H); }), "jacobian of HyL: index -1 is out of range");
  MatrixXd wide(7, 3);
  EXPECT_EQ(
      message_of([&] { leg.jacobian(0, three, wide.topRows(6)); }), "jacobian: the columns of J must be contiguous");
  EXPECT_EQ(
      message_of([&] { make_any<hyl::Robot>(puma560::reflection::robot); }),
      "AnyRobot: the tables belong to another robot");
}

// Standard gravity applies to a fixed base. A default in base coordinates would be wrong for a tilted base.
TEST(AnyRobot, AsksForGravityWhereTheBaseFloats) {
  const AnyRobot robot = make_any<quadruped::Robot>(quadruped::reflection::robot);
  const VectorXd q = VectorXd::Zero(12), v = VectorXd::Zero(18);
  VectorXd tau(12), f(18);
  const std::string end = " of Quadruped: the base floats: give gravity in base coordinates";
  EXPECT_EQ(message_of([&] { robot.inverse_dynamics(q, v, q, tau); }), "inverse_dynamics" + end);
  EXPECT_EQ(
      message_of([&] { robot.inverse_dynamics_fully_actuated(q, v, v, f); }), "inverse_dynamics_fully_actuated" + end);
  EXPECT_EQ(message_of([&] { robot.forward_dynamics(q, v, q, f); }), "forward_dynamics" + end);
  EXPECT_EQ(message_of([&] { robot.bias_forces(q, v, f); }), "bias_forces" + end);
  EXPECT_EQ(message_of([&] { robot.gravity_forces(q, f); }), "gravity_forces" + end);
  EXPECT_EQ(message_of([&] { robot.gravity_forces(q, f, kStandardGravity); }), "no error");
}

TEST(AnyRobot, HasTransformsAndJacobiansByName) {
  const AnyRobot leg = make_any<hyl::Robot>(hyl::reflection::robot);
  const VectorXd q = Eigen::Vector3d(0.6, -0.6, 1.2);
  const int pose = leg.find_transform("fr_base_X_fr_foot"), jacobian = leg.find_jacobian("fr_base_J_fr_foot");
  ASSERT_GE(pose, 0);
  ASSERT_GE(jacobian, 0);
  EXPECT_EQ(leg.find_transform("fr_base_X_fr_nose"), -1);
  EXPECT_EQ(leg.homogeneous_transform(pose, q), hyl::transforms::homogeneous::fr_base_X_fr_foot(q));
  EXPECT_EQ(leg.motion_transform(pose, q), hyl::transforms::motion::fr_base_X_fr_foot(q));
  EXPECT_EQ(leg.force_transform(pose, q), hyl::transforms::force::fr_base_X_fr_foot(q));
  MatrixXd J(6, 3);
  leg.jacobian(jacobian, q, J);
  EXPECT_EQ(J, hyl::jacobians::fr_base_J_fr_foot(q));
}

TEST(AnyRobot, HasLimitsOfJoints) {
  const AnyRobot robot = make_any<quadruped::Robot>(quadruped::reflection::robot);
  EXPECT_EQ(robot.joint_limits().size(), 12U);
  EXPECT_EQ(robot.joint_limits().data(), quadruped::Robot::kJointLimits.data());
}

TEST(AnyRobot, CarriesTheValuesOfParameters) {
  hyl_parametric::ParameterValues values;
  values.lowerleg_mass = 2;
  values.lowerleg_length = 0.4;
  hyl_parametric::Robot direct;
  direct.parameters.update(values);
  const AnyRobot robot = make_any(hyl_parametric::reflection::robot, direct);
  const AnyRobot defaults = make_any<hyl_parametric::Robot>(hyl_parametric::reflection::robot);
  const VectorXd q = Eigen::Vector3d(0.6, -0.6, 1.2);
  VectorXd f(3), of_defaults(3);
  robot.gravity_forces(q, f);
  defaults.gravity_forces(q, of_defaults);
  EXPECT_EQ(f, direct.gravity_forces(q, Gravity::standard()));
  EXPECT_NE(f, of_defaults);
  const int pose = robot.find_transform("fr_base_X_fr_foot");
  EXPECT_NE(robot.homogeneous_transform(pose, q), defaults.homogeneous_transform(pose, q));
}

// The matrix may be a part of a larger one.
TEST(AnyRobot, WritesIntoBlocks) {
  const AnyRobot leg = make_any<hyl::Robot>(hyl::reflection::robot);
  const Eigen::Vector3d q(0.6, -0.6, 1.2);
  MatrixXd all = MatrixXd::Constant(5, 5, 7);
  leg.joint_space_inertia(q, all.block(1, 1, 3, 3));
  EXPECT_EQ(all.block(1, 1, 3, 3), hyl::joint_space_inertia(q));
  EXPECT_EQ(all(0, 0), 7);
  EXPECT_EQ(all(4, 1), 7);
}

}  // namespace
}  // namespace robcogen::test::any_robot_test
