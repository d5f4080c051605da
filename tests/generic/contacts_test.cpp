// Compiled contact functions of floating robots, with points and with surfaces, compared with the dense equations of
// the reference in long double: with no, one, two and all contacts active.
#include <gtest/gtest.h>
#include <humanoid_on_soles/humanoid_on_soles.h>
#include <humanoid_on_soles/reflection.h>
#include <quadruped_on_feet/quadruped_on_feet.h>
#include <quadruped_on_feet/reflection.h>

#include "poses.h"
#include "robcogen/concepts.h"
#include "robcogen/generic/simulation.h"
#include "robcogen/reference/contacts.h"

namespace robcogen::test {
namespace {

using Real = long double;

constexpr int kStates = 20;
constexpr double kDense = 1e-10;   // of the largest result
constexpr double kDigits = 1e-12;  // systems that a dense solve in double solves less exactly are skipped
constexpr float kSingle = 2e-3F;   // of the largest result, in single precision

template <class Vector>
reference::Vector<Real> real(const Vector& v) {
  reference::Vector<Real> result(static_cast<int>(v.size()));
  for (int i = 0; i < result.rows(); ++i) result(i) = v(i);
  return result;
}

template <class Robot, class Single>
class ContactCase {
 public:
  static constexpr int kRows = kContactRows<Robot>, kDof = Robot::kDof;
  using Rows = Eigen::Matrix<double, kRows, 1>;

  explicit ContactCase(const reflection::Robot& tables) : tables_(tables) {}

  // Compares one state with the contacts of `active`, which are rigid. Returns whether the state was compared.
  template <class Active>
  bool compare(std::mt19937_64& engine, const Active& active) const {
    typename Robot::JointState q, qd, tau;
    for (double& x : q) x = reference::uniform(engine, 0.8);
    for (double& x : qd) x = reference::uniform(engine, 1.0);
    for (double& x : tau) x = reference::uniform(engine, 30.0);
    Rows wanted;
    for (double& x : wanted) x = reference::uniform(engine, 3.0);
    const Twist velocity(random_vector<double>(engine), random_vector<double>(engine));
    const Gravity gravity = gravity_in_base(random_pose<double>(engine));

    reference::Motion<Real> motion;
    motion.q = real(q);
    motion.qd = real(qd);
    motion.qdd = reference::Vector<Real>(kDof);
    motion.base_velocity = real(velocity.vector());
    motion.base_acceleration = reference::Vector<Real>(6);
    const auto loads = reference::loads<Real>(
        reference::Vector<double>{gravity.vector().x(), gravity.vector().y(), gravity.vector().z()});
    const auto bias = reference::bias_forces(tables_, motion, loads);
    reference::Vector<Real> forces(6 + kDof);
    forces.set_block(6, 0, real(tau));
    const std::vector<double> by_contact(active.begin(), active.end());
    const auto expected = reference::solve_contacts(
        reference::joint_space_inertia(tables_, motion.q), reference::contact_jacobian(tables_, motion.q),
        forces - reference::stacked(bias.base_wrench, bias.tau),
        real(wanted) - reference::contact_bias(tables_, motion), reference::by_row(tables_, by_contact),
        std::vector<double>(kRows), kDigits);
    if (!expected) return false;

    const Robot robot;
    const auto found = robot.constrained_forward_dynamics(q, qd, tau, velocity, wanted, active, Rows::Zero(), gravity);
    const Real size = 1 + reference::largest(*expected);
    const auto near = [&](const auto& part, int first, double tolerance) {
      Real most = 0;
      for (int i = 0; i < part.size(); ++i) most = std::max(most, std::abs(Real(part(i)) - (*expected)(first + i)));
      EXPECT_LT(static_cast<double>(most / size), tolerance);
    };
    near(found.base_acceleration.vector(), 0, kDense);
    near(found.qdd, 6, kDense);
    near(found.contact_wrenches, 6 + kDof, kDense);
    for (int r = 0; r < kRows; ++r)
      EXPECT_TRUE(active[r / (kRows / active.size())] != 0 || found.contact_wrenches[r] == 0.0) << r;

    const Single single;
    using Twist32 = BasicTwist<float>;
    const auto rough = single.constrained_forward_dynamics(
        q.template cast<float>(), qd.template cast<float>(), tau.template cast<float>(),
        Twist32(velocity.vector().template cast<float>()), wanted.template cast<float>(), active.template cast<float>(),
        Rows::Zero().template cast<float>(), BasicGravity<float>(gravity.vector().template cast<float>()));
    near(rough.base_acceleration.vector(), 0, kSingle);
    near(rough.qdd, 6, kSingle);
    near(rough.contact_wrenches, 6 + kDof, kSingle);
    return true;
  }

 private:
  const reflection::Robot& tables_;
};

TEST(CompiledContacts, PointsSolveTheDenseSystem) {
  const ContactCase<quadruped_on_feet::Robot, quadruped_on_feet::f32::Robot> robot(
      quadruped_on_feet::reflection::robot);
  std::mt19937_64 engine(61);
  const Eigen::Vector4d choices[] = {{0, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 1}, {1, 1, 1, 1}};
  for (const Eigen::Vector4d& active : choices) {
    SCOPED_TRACE(testing::Message() << active.transpose());
    int compared = 0;
    for (int i = 0; i < kStates; ++i) compared += robot.compare(engine, active) ? 1 : 0;
    EXPECT_GT(compared, kStates / 2);
  }
}

// Results are passed on to a simulation: active contacts keep their velocity over a short step, and bounce at an
// impact.
TEST(CompiledContacts, MoveAState) {
  using Robot = quadruped_on_feet::Robot;
  using Rows = Eigen::Matrix<double, kContactRows<Robot>, 1>;
  constexpr double kShort = 1e-6, kRest = 0.25;  // s; of the velocity before
  std::mt19937_64 engine(63);
  State<Robot> state;
  for (double& x : state.q) x = 0.5 + reference::uniform(engine, 0.3);
  for (double& x : state.qd) x = reference::uniform(engine, 1.0);
  state.pose = random_pose<double>(engine);
  state.base_velocity = Twist(random_vector<double>(engine), random_vector<double>(engine));
  const Eigen::Vector4d active = Eigen::Vector4d::Ones();
  const auto velocity = [](const State<Robot>& s) { return Robot::contact_velocity(s.q, s.qd, s.base_velocity); };
  const Rows before = velocity(state);

  const auto motion = Robot::constrained_forward_dynamics(
      state.q, state.qd, Robot::JointState::Zero(), state.base_velocity, Rows::Zero(), active, Rows::Zero(),
      gravity_in_base(state));
  // In axes of the world: the base turns during the step.
  const State<Robot> next = integrate(state, motion, kShort);
  const Rows after = velocity(next);
  for (int foot = 0; foot < 4; ++foot) {
    const Eigen::Vector3d change =
        next.pose.to_world_axes(after.segment<3>(3 * foot)) - state.pose.to_world_axes(before.segment<3>(3 * foot));
    EXPECT_LT(change.norm() / kShort, 1e-3) << foot;  // m/s^2
  }

  const auto impact =
      Robot::impact(state.q, state.qd, state.base_velocity, Eigen::Vector4d::Constant(kRest), active, Rows::Zero());
  static_assert(std::is_same_v<decltype(impact.base_velocity_after), Twist>);
  EXPECT_LT((velocity(after_impact(state, impact)) + kRest * before).norm(), kDense);
}

TEST(CompiledContacts, SurfacesSolveTheDenseSystem) {
  const ContactCase<humanoid_on_soles::Robot, humanoid_on_soles::f32::Robot> robot(
      humanoid_on_soles::reflection::robot);
  std::mt19937_64 engine(62);
  const Eigen::Vector2d choices[] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  for (const Eigen::Vector2d& active : choices) {
    SCOPED_TRACE(testing::Message() << active.transpose());
    int compared = 0;
    for (int i = 0; i < kStates; ++i) compared += robot.compare(engine, active) ? 1 : 0;
    EXPECT_GT(compared, kStates / 2);
  }
}

}  // namespace
}  // namespace robcogen::test
