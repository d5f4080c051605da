// Types, constants, overload sets and tables of generated headers.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <type_traits>

#include "cart_pole/cart_pole.h"
#include "cart_pole/reflection.h"
#include "legs/floating/hopper/hopper.h"
#include "legs/floating/hopper/reflection.h"
#include "my/robcogen/class/robot/robot.h"
#include "plinth/plinth.h"
#include "plinth/reflection.h"
#include "samples.h"
#include "symbolic/cost.h"

namespace robcogen::test::interface_test {
namespace {

using legs::floating::hopper::Robot;
using State = legs::floating::hopper::JointState;
using Wrenches = legs::floating::hopper::LinkWrenches;

template <class... Arguments>
constexpr bool kInverseDynamics = requires(const Arguments&... a) {
  Robot::inverse_dynamics_fully_actuated(a...);
};

TEST(Interface, SwappedArgumentsDoNotCompile) {
  EXPECT_TRUE((kInverseDynamics<State, State, State, Twist, SpatialAcceleration, Gravity>));
  EXPECT_FALSE((kInverseDynamics<State, State, State, SpatialAcceleration, Twist, Gravity>));
  EXPECT_FALSE((kInverseDynamics<State, State, State, Twist, Gravity, SpatialAcceleration>));
  EXPECT_FALSE((kInverseDynamics<State, State, State, Wrench, SpatialAcceleration>));
  EXPECT_FALSE((kInverseDynamics<State, State, State, Eigen::Matrix<double, 6, 1>, SpatialAcceleration>));
  EXPECT_FALSE((kInverseDynamics<State, State, State, Twist, SpatialAcceleration, Eigen::Vector3d>));
}

// A default in base coordinates would be wrong for a tilted base.
TEST(Interface, AFloatingBaseTakesGravity) {
  EXPECT_FALSE((kInverseDynamics<State, State, State, Twist, SpatialAcceleration>));
  EXPECT_FALSE((kInverseDynamics<State, State, State, Twist, SpatialAcceleration, Wrenches>));
  EXPECT_TRUE((kInverseDynamics<State, State, State, Twist, SpatialAcceleration, Gravity>));
  EXPECT_TRUE((kInverseDynamics<State, State, State, Twist, SpatialAcceleration, Gravity, Wrenches>));
  EXPECT_FALSE((kInverseDynamics<State, State, State, Twist, SpatialAcceleration, Wrenches, Gravity>));
}

TEST(Interface, ResultsHaveTheirTypes) {
  using namespace cart_pole;
  const JointState q = JointState::Zero();
  static_assert(std::is_same_v<decltype(inverse_dynamics(q, q, q)), Eigen::Matrix<double, 2, 1>>);
  static_assert(std::is_same_v<decltype(f32::joint_space_inertia({})), Eigen::Matrix<float, 2, 2>>);
  static_assert(std::is_same_v<decltype(transforms::homogeneous::fr_base_X_fr_tip(q)), Eigen::Matrix4d>);
  static_assert(std::is_same_v<decltype(jacobians::fr_base_J_fr_tip(q)), Eigen::Matrix<double, 6, 2>>);
  static_assert(std::is_same_v<legs::floating::hopper::InertiaMatrix, Eigen::Matrix<double, 7, 7>>);
  static_assert(noexcept(inverse_dynamics(q, q, q)));
  const double* input = q.data();
  double* output = nullptr;
  static_assert(noexcept(kernel::inverse_dynamics(input, input, input, output)));
  static_assert(noexcept(cart_pole::Robot::forward_dynamics(q, q, q, Gravity::standard())));
  const auto [tau, base_acceleration] =
      legs::floating::hopper::inverse_dynamics(State(1), State(2), State(3), Twist(), kStandardGravity);
  EXPECT_EQ(tau.size(), 1);
  EXPECT_EQ(base_acceleration.vector().size(), 6);
}

// The factor is made from a position only and has its own type in each precision; no function of it allocates or
// throws.
TEST(Interface, FactorOfTheInertiaMatrix) {
  using namespace cart_pole;
  const JointState q(0.3, -0.4);
  const InertiaFactor factor = cart_pole::Robot::joint_space_inertia_factor(q);
  static_assert(std::is_same_v<cart_pole::Robot::InertiaFactor, InertiaFactor>);
  static_assert(std::is_same_v<decltype(factor.L()), const InertiaMatrix&>);
  static_assert(std::is_same_v<decltype(factor.inverse_diagonal()), const JointState&>);
  static_assert(std::is_same_v<decltype(factor.solve(q)), JointState>);
  static_assert(std::is_same_v<decltype(f32::joint_space_inertia_factor({}).inverse()), Eigen::Matrix2f>);
  static_assert(noexcept(joint_space_inertia_factor(q))&& noexcept(InertiaFactor(q)));
  static_assert(noexcept(factor.L())&& noexcept(factor.solve(q)));
  static_assert(noexcept(factor.inverse())&& noexcept(factor.inverse_L()));
  static_assert(!std::is_convertible_v<JointState, InertiaFactor>);
  EXPECT_EQ(factor.solve(q + q), factor.solve(2 * q));
}

// Eigen expressions are accepted as arguments, in either precision.
TEST(Interface, TakesExpressions) {
  const cart_pole::JointState q(0.1, 0.2);
  EXPECT_EQ(cart_pole::gravity_forces(q + q), cart_pole::gravity_forces(cart_pole::JointState(0.2, 0.4)));
  const cart_pole::f32::JointState f(0.1f, 0.2f);
  EXPECT_EQ(cart_pole::f32::gravity_forces(2 * f), cart_pole::f32::gravity_forces(f + f));
}

TEST(Interface, ConstantsOfTheModel) {
  using namespace cart_pole;
  static_assert(kDof == 2 && kLinkCount == 3 && kFrameCount == 6 && !kFloatingBase);
  static_assert(index(Joint::POLE) == 1 && index(Link::base) == 0 && index(Frame::fr_tip) == 5);
  static_assert(kJointTypes[0] == JointType::prismatic && kJointTypes[1] == JointType::revolute);
  static_assert(kJointParents[1] == Link::cart && kJointChildren[1] == Link::pole);
  static_assert(kLinkParentJoints[0] == -1 && kLinkParentJoints[2] == index(Joint::POLE));
  static_assert(kFrameLinks[5] == Link::pole);
  static_assert(cart_pole::Robot::kDof == 2 && Robot::kFloatingBase && Robot::kLinkCount == 2);
  static_assert(kJointLimits[0].lower == -0.1 && kJointLimits[0].upper == 2.5 && kJointLimits[0].velocity == 3);
  static_assert(kJointLimits[0].effort == kUnlimited && cart_pole::Robot::kJointLimits[1].lower == -kUnlimited);
  EXPECT_STREQ(kJointNames[1], "POLE");
  EXPECT_STREQ(kLinkNames[1], "cart");
  EXPECT_STREQ(kFrameNames[0], "fr_base");
  EXPECT_STREQ(kName, "cart_pole");
  EXPECT_STREQ(kModelHash, "0123456789abcdef");
}

TEST(Interface, JacobiansListTheirColumns) {
  using namespace cart_pole;
  static_assert(jacobians::fr_base_J_fr_tip_columns[1] == Joint::POLE);
  static_assert(jacobians::fr_base_J_fr_base_columns.empty());
}

TEST(Interface, NamesOfTheDocumentStayInTheTables) {
  using namespace my::robcogen_::class_::robot;
  EXPECT_STREQ(kName, "R\"obot\\");
  EXPECT_STREQ(kJointNames[static_cast<std::size_t>(index(Joint::class_))], "class");
  EXPECT_STREQ(kJointNames[static_cast<std::size_t>(index(Joint::I_))], "I");
  EXPECT_STREQ(kJointNames[static_cast<std::size_t>(index(Joint::x))], "_x");
  EXPECT_NE(Joint::hfe, Joint::HFE);
}

TEST(Interface, RobotHasTheSameFunctions) {
  const cart_pole::JointState q(0.3, 0.4), qd(1, 2), tau(0.5, -0.5);
  using R = cart_pole::Robot;
  EXPECT_EQ(R::forward_dynamics(q, qd, tau), cart_pole::forward_dynamics(q, qd, tau));
  EXPECT_EQ(
      R::forward_dynamics(q, qd, tau, R::LinkWrenches()), cart_pole::forward_dynamics(q, qd, tau, R::LinkWrenches()));
  EXPECT_EQ(R::joint_space_inertia(q), cart_pole::joint_space_inertia(q));
  EXPECT_EQ(
      Robot::gravity_forces(State(1), kStandardGravity).tau,
      legs::floating::hopper::gravity_forces(State(1), kStandardGravity).tau);
}

TEST(Reflection, TablesHoldTheModel) {
  const reflection::Robot& r = cart_pole::reflection::robot;
  EXPECT_STREQ(r.name, "cart_pole");
  EXPECT_FALSE(r.floating_base);
  ASSERT_EQ(r.links.size, 3);
  EXPECT_EQ(r.links[2].parent_joint, 1);
  EXPECT_EQ(r.links[2].mass, 0.4);
  EXPECT_EQ(r.links[2].com[2], -0.7);
  ASSERT_EQ(r.joints.size, 2);
  EXPECT_EQ(r.joints[0].type, robcogen::JointType::prismatic);
  EXPECT_EQ(r.joints[1].child, 2);
  ASSERT_EQ(r.frames.size, 6);
  EXPECT_EQ(r.frames[5].translation[2], -0.7);
}

TEST(Reflection, TablesCallTheKernels) {
  const reflection::Robot& r = cart_pole::reflection::robot;
  ASSERT_EQ(r.transforms.size, 1);
  const cart_pole::JointState q(0.3, -0.4);
  Eigen::Matrix4d X;
  r.transforms[0].homogeneous(nullptr, q.data(), X.data());
  EXPECT_EQ(X, cart_pole::transforms::homogeneous::fr_base_X_fr_tip(q));
  Eigen::Matrix<double, 6, 6> XM, XF;
  r.transforms[0].motion(nullptr, q.data(), XM.data());
  r.transforms[0].force(nullptr, q.data(), XF.data());
  EXPECT_EQ(XM, cart_pole::transforms::motion::fr_base_X_fr_tip(q));
  EXPECT_EQ(XF, cart_pole::transforms::force::fr_base_X_fr_tip(q));
  ASSERT_EQ(r.jacobians.size, 2);
  EXPECT_EQ(r.jacobians[0].column_count, 2);
  EXPECT_EQ(r.jacobians[0].columns[1], 1);
  EXPECT_EQ(r.jacobians[1].column_count, 0);
  Eigen::Matrix<double, 6, 2> J;
  r.jacobians[0].kernel(nullptr, q.data(), J.data());
  EXPECT_EQ(J, cart_pole::jacobians::fr_base_J_fr_tip(q));
}

TEST(Reflection, FunctionsCarryTheirOperationCounts) {
  const backend::Library library = test::cart_pole();
  const reflection::Robot& r = ::cart_pole::reflection::robot;
  ASSERT_EQ(static_cast<std::size_t>(r.functions.size), library.functions.size());
  for (int k = 0; k < r.functions.size; ++k) {
    const backend::Function& f = library.functions[static_cast<std::size_t>(k)];
    const symbolic::Cost expected = symbolic::cost(f.program);
    EXPECT_EQ(r.functions[k].name, f.kernel);
    EXPECT_EQ(r.functions[k].count.mul, expected.mul);
    EXPECT_EQ(r.functions[k].count.add, expected.add);
    EXPECT_EQ(r.functions[k].count.div, expected.div);
    EXPECT_EQ(r.functions[k].count.sincos, expected.sincos);
    EXPECT_EQ(r.functions[k].count.critical_path, expected.critical_path);
  }
}

TEST(Reflection, MissingGroupsAreEmptyTables) {
  EXPECT_TRUE(legs::floating::hopper::reflection::robot.floating_base);
  EXPECT_EQ(legs::floating::hopper::reflection::robot.transforms.size, 0);
  EXPECT_EQ(plinth::reflection::robot.joints.size, 0);
  EXPECT_EQ(plinth::reflection::robot.joints.begin(), plinth::reflection::robot.joints.end());
}

}  // namespace
}  // namespace robcogen::test::interface_test
