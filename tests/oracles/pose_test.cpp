// The state of a floating robot in MuJoCo's arrays: the robot moves and stands there as it does in this project.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>
#include <quadruped/quadruped.h>

#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "robcogen/conversions.h"
#include "robcogen/generic/simulation.h"
#include "robcogen/reference/samples.h"
#include "robcogen/world.h"

namespace robcogen::oracles {
namespace {

using Robot = quadruped::Robot;
using State = robcogen::State<Robot>;

// Relative to the largest element, for two programs in double precision, with light links on heavy ones.
constexpr double kAgreement = 1e-9;
constexpr int kStates = 100;
constexpr int kDof = quadruped::kDof;

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

class PoseInMujoco : public ::testing::Test {
 protected:
  PoseInMujoco() {
    char error[1000] = "";
    model_.reset(mj_loadXML(URDF, nullptr, error, sizeof error));
    mj_freeLastXML();
    if (!model_) throw std::runtime_error(error);
    model_->opt.disableflags |= mjDSBL_CONTACT | mjDSBL_CONSTRAINT;
    data_.reset(mj_makeData(model_.get()));
  }

  JointOrder<kDof> order() const {
    std::vector<const char*> names;  // after the floating joint
    for (int j = 1; j < model_->njnt; ++j) names.push_back(mj_id2name(model_.get(), mjOBJ_JOINT, j));
    const auto match = match_joints(quadruped::kJointNames, names);
    if (!match.order) throw std::runtime_error(std::string(match.name));
    return *match.order;
  }

  // Draws a random state, with quaternions of any length and sign.
  void randomise(std::mt19937_64& engine) {
    for (int i = 0; i < model_->nq; ++i) data_->qpos[i] = reference::uniform(engine, 2.0);
    for (int i = 0; i < model_->nv; ++i) data_->qvel[i] = reference::uniform(engine, 2.0);
  }

  State state() const { return from_mujoco<State>(data_->qpos, data_->qvel, order()); }

  std::unique_ptr<mjModel, Deleter> model_;
  std::unique_ptr<mjData, Deleter> data_;
};

TEST_F(PoseInMujoco, ForwardDynamicsAgree) {
  std::mt19937_64 engine(41);
  for (int i = 0; i < kStates; ++i) {
    randomise(engine);
    quadruped::JointState tau;
    for (double& x : tau) x = reference::uniform(engine, 20.0);
    order().to(tau, data_->qfrc_applied + 6);
    mj_forward(model_.get(), data_.get());

    const State s = state();
    const auto ours = acceleration(Robot(), s, tau);
    const auto base = classical_from_spatial(ours.base_acceleration, s.base_velocity);
    Eigen::VectorXd expected(6 + kDof), theirs = Eigen::Map<Eigen::VectorXd>(data_->qacc, 6 + kDof);
    expected << s.pose.to_world_axes(base.linear()), base.angular(), Eigen::VectorXd::Zero(kDof);
    order().to(ours.qdd, expected.data() + 6);
    EXPECT_LT((theirs - expected).cwiseAbs().maxCoeff(), kAgreement * expected.cwiseAbs().maxCoeff());
  }
}

TEST_F(PoseInMujoco, FramesStandWhereTheyDo) {
  namespace homogeneous = quadruped::transforms::homogeneous;
  std::mt19937_64 engine(42);
  const int body = mj_name2id(model_.get(), mjOBJ_BODY, "LF_lowerleg");
  ASSERT_GE(body, 0);
  for (int i = 0; i < kStates; ++i) {
    randomise(engine);
    const State s = state();
    to_mujoco(s, order(), data_->qpos, data_->qvel);
    mj_kinematics(model_.get(), data_.get());
    const Eigen::Matrix4d X = s.pose.homogeneous() * homogeneous::fr_trunk_X_fr_LF_lowerleg(s.q);
    const Eigen::Map<const Eigen::Vector3d> position(data_->xpos + 3 * body);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(data_->xmat + 9 * body);
    EXPECT_LT((X.topRightCorner<3, 1>() - position).norm(), kAgreement);
    EXPECT_LT((X.topLeftCorner<3, 3>() - rotation).norm(), kAgreement);
  }
}

// A step from the same accelerations: MuJoCo adds the classical acceleration to the velocity of the base in world axes,
// and moves its origin along a straight line. What the guide says of the difference is exact up to third order.
TEST_F(PoseInMujoco, StepsOfTheBaseDifferAtSecondOrder) {
  const Robot robot;
  std::mt19937_64 engine(46);
  for (int i = 0; i < 10; ++i) {
    randomise(engine);
    const std::vector<double> qpos(data_->qpos, data_->qpos + model_->nq), qvel(data_->qvel, data_->qvel + model_->nv);
    // The error of the second-order terms.
    const auto error = [&](double h) {
      mj_resetData(model_.get(), data_.get());
      mju_copy(data_->qpos, qpos.data(), model_->nq);
      mju_copy(data_->qvel, qvel.data(), model_->nv);
      mju_normalize4(data_->qpos + 3);
      model_->opt.timestep = h;
      const State s = state();
      const auto motion = acceleration(robot, s, quadruped::JointState::Zero());
      const State ours = integrate(s, motion, h);
      mj_step(model_.get(), data_.get());
      const State theirs = state();
      EXPECT_LT((ours.q - theirs.q).norm() + (ours.qd - theirs.qd).norm(), kAgreement * (1 + motion.qdd.norm()));
      EXPECT_LT((ours.pose.rotation() - theirs.pose.rotation()).norm(), kAgreement);
      const Eigen::Vector3d w = s.base_velocity.angular(), v = s.base_velocity.linear(),
                            alpha = motion.base_acceleration.angular(), a = motion.base_acceleration.linear();
      const Eigen::Vector3d position = -h * h / 2 * s.pose.to_world_axes(w.cross(v));
      const Eigen::Vector3d velocity =
          h * h * s.pose.to_world_axes(alpha.cross(v) + w.cross(a) + w.cross(w.cross(v)) / 2);
      Eigen::Matrix<double, 6, 1> difference;
      difference << ours.pose.position() - theirs.pose.position() - position,
          ours.pose.to_world_axes(ours.base_velocity.linear()) -
              theirs.pose.to_world_axes(theirs.base_velocity.linear()) - velocity;
      return difference;
    };
    const auto coarse = error(2e-4), fine = error(1e-4);
    EXPECT_NEAR(coarse.head<3>().norm() / fine.head<3>().norm(), 8, 0.5) << i;
    EXPECT_NEAR(coarse.tail<3>().norm() / fine.tail<3>().norm(), 8, 0.5) << i;
  }
}

TEST_F(PoseInMujoco, JacobiansWithBaseAgree) {
  namespace jacobians = quadruped::jacobians;
  std::mt19937_64 engine(44);
  const int body = mj_name2id(model_.get(), mjOBJ_BODY, "LF_lowerleg");
  for (int i = 0; i < kStates; ++i) {
    randomise(engine);
    mj_forward(model_.get(), data_.get());
    const State s = state();
    const Eigen::Matrix4d X = quadruped::transforms::homogeneous::fr_trunk_X_fr_LF_foot(s.q);
    const Eigen::Matrix3d R = s.pose.rotation();
    const auto J = rows_in_axes(
        R,
        jacobian_with_base<kDof>(X, jacobians::fr_trunk_J_fr_LF_foot(s.q), jacobians::fr_trunk_J_fr_LF_foot_columns));
    const Eigen::Vector3d foot = (s.pose.homogeneous() * X).topRightCorner<3, 1>();
    Eigen::Matrix<double, 6, 6 + kDof, Eigen::RowMajor> theirs;
    mj_jac(model_.get(), data_.get(), theirs.row(3).data(), theirs.row(0).data(), foot.data(), body);

    Eigen::Matrix<double, 6, 6 + kDof> ours;
    ours.leftCols<3>() = J.middleCols<3>(3) * R.transpose();  // velocity of the base in world axes
    ours.middleCols<3>(3) = J.leftCols<3>();
    for (int j = 0; j < kDof; ++j) ours.col(6 + order()[static_cast<std::size_t>(j)]) = J.col(6 + j);
    EXPECT_LT((theirs - ours).cwiseAbs().maxCoeff(), kAgreement);
  }
}

// Compares generated functions: the Jacobian and the motion of a foot, the centre of mass, and the momentum.
TEST_F(PoseInMujoco, FramesMoveInTheWorldAsTheyDo) {
  namespace world = quadruped::world;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  std::mt19937_64 engine(45);
  const int body = mj_name2id(model_.get(), mjOBJ_BODY, "LF_lowerleg");
  const int trunk = mj_name2id(model_.get(), mjOBJ_BODY, "trunk");
  ASSERT_GE(trunk, 0);
  // MuJoCo's columns of the base are the velocity in world axes, then the angular velocity.
  const auto columns = [&](const auto& J, const Eigen::Matrix3d& R) {
    Eigen::Matrix<double, Eigen::Dynamic, 6 + kDof> result(J.rows(), 6 + kDof);
    result.template leftCols<3>() = J.template middleCols<3>(3) * R.transpose();
    result.template middleCols<3>(3) = J.template leftCols<3>();
    for (int j = 0; j < kDof; ++j) result.col(6 + order()[static_cast<std::size_t>(j)]) = J.col(6 + j);
    return result;
  };
  for (int i = 0; i < kStates; ++i) {
    randomise(engine);
    mj_forward(model_.get(), data_.get());
    mj_subtreeVel(model_.get(), data_.get());
    mj_rnePostConstraint(model_.get(), data_.get());
    const State s = state();
    const Eigen::Matrix3d R = s.pose.rotation();
    const Eigen::Vector3d foot = world::position_fr_LF_foot(s.q, s.pose);
    Eigen::Matrix<double, 6, 6 + kDof, Eigen::RowMajor> theirs;
    mj_jac(model_.get(), data_.get(), theirs.row(3).data(), theirs.row(0).data(), foot.data(), body);
    EXPECT_LT((theirs - columns(world::J_fr_LF_foot(s.q, s.pose), R)).cwiseAbs().maxCoeff(), kAgreement);
    const Eigen::Map<const Eigen::Matrix<double, 6 + kDof, 1>> velocities(data_->qvel), accelerations(data_->qacc);
    const Vector6 velocity = world::velocity_fr_LF_foot(s.q, s.qd, s.pose, s.base_velocity);
    EXPECT_LT((velocity - theirs * velocities).norm(), kAgreement * (1 + velocity.norm()));

    // From the body's origin to the foot; MuJoCo's accelerations include gravity.
    Vector6 origin;
    mj_objectAcceleration(model_.get(), data_.get(), mjOBJ_XBODY, body, origin.data(), 0);
    const Eigen::Vector3d arm = foot - Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * body);
    const Eigen::Vector3d w = velocity.head<3>(), wd = origin.head<3>();
    const Eigen::Vector3d gravity(model_->opt.gravity);
    Vector6 expected;
    expected << wd, origin.tail<3>() + gravity + wd.cross(arm) + w.cross(w.cross(arm));
    quadruped::JointState qdd;
    order().from(data_->qacc + 6, qdd);
    const ClassicalAcceleration base(
        accelerations.segment<3>(3), s.pose.to_base_axes(Eigen::Vector3d(accelerations.head<3>())));
    const Vector6 ours = world::acceleration_fr_LF_foot(
        s.q, s.qd, qdd, s.pose, s.base_velocity, spatial_from_classical(base, s.base_velocity));
    EXPECT_LT((ours - expected).norm(), kAgreement * (1 + expected.norm()));

    const Eigen::Map<const Eigen::Vector3d> com(data_->subtree_com + 3 * trunk);
    const Eigen::Map<const Eigen::Vector3d> linear(data_->subtree_linvel + 3 * trunk);
    const Eigen::Map<const Eigen::Vector3d> angular(data_->subtree_angmom + 3 * trunk);
    EXPECT_LT((world::center_of_mass(s.q, s.pose) - com).norm(), kAgreement);
    const Eigen::Vector3d com_velocity = world::center_of_mass_velocity(s.q, s.qd, s.pose, s.base_velocity);
    EXPECT_LT((com_velocity - linear).norm(), kAgreement * (1 + linear.norm()));
    const Vector6 momentum = world::centroidal_momentum(s.q, s.qd, s.pose, s.base_velocity);
    EXPECT_LT((momentum.head<3>() - angular).norm(), kAgreement * (1 + angular.norm()));
    EXPECT_LT((momentum.tail<3>() - quadruped::kTotalMass * linear).norm(), kAgreement * (1 + momentum.norm()));
    Eigen::Matrix<double, 3, 6 + kDof, Eigen::RowMajor> of_com;
    mj_jacSubtreeCom(model_.get(), data_.get(), of_com.data(), trunk);
    EXPECT_LT((of_com - columns(world::center_of_mass_jacobian(s.q, s.pose), R)).cwiseAbs().maxCoeff(), kAgreement);
  }
}

// MuJoCo moves the origin in a straight line along the initial velocity; rotations are the same.
TEST_F(PoseInMujoco, OrientationsTurnEqually) {
  std::mt19937_64 engine(43);
  for (int i = 0; i < kStates; ++i) {
    randomise(engine);
    const State before = state();
    mj_integratePos(model_.get(), data_->qpos, data_->qvel, 0.3);
    const BasePose after = integrate(before.pose, before.base_velocity, 0.3);
    EXPECT_LT(difference(after, state().pose).angular().norm(), kAgreement);
  }
}

}  // namespace
}  // namespace robcogen::oracles
