// The import of MJCF with loops, in the interpreter, compared with MuJoCo on the same file: its constraints hold in the
// positions and velocities of this project, and its inertia matrix, bias forces and constraint Jacobian give the same
// accelerations. The files are those of the folder mjcf_loops, and those that the program's arguments name.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <random>

#include "import/identifier.h"
#include "interpreted_robot.h"
#include "judge.h"
#include "linear_algebra.h"
#include "mjcf_files.h"

namespace robcogen::oracles {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::filesystem::path;

// Relative to the largest element: differences of the fourth order give the change of the Jacobian.
constexpr double kAgreement = 1e-7;
// In metres and radians, and in metres per second.
constexpr double kClosed = 1e-9;
constexpr int kStates = 8;

Matrix3d rotation(const double (&angles)[3]) {
  return (Eigen::AngleAxisd(angles[0], Vector3d::UnitX()) * Eigen::AngleAxisd(angles[1], Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()))
      .toRotationMatrix();
}

class Comparison {
 public:
  Comparison(model::KinematicTree tree, mjModel& model)
      : robot_(
            without_passive_forces(tree),
            {},
            numeric::all_steps(),
            {},
            {},
            {"forward_dynamics", "joint_space_inertia"}),
        tables_(robot_.tables()),
        model_(model),
        data_(mj_makeData(&model)),
        base_(tree.floating_base ? 6 : 0) {
    for (int id = 0; id < model.njnt; ++id) {
      if (model.jnt_type[id] == mjJNT_FREE) continue;
      const std::string name = import::identifier(mj_id2name(&model, mjOBJ_JOINT, id));
      if (model.jnt_type[id] != mjJNT_BALL) {
        scalars_.emplace_back(id, joint_called(name));
        continue;
      }
      Ball ball{id, {}, Matrix3d::Identity()};
      for (std::size_t i = 0; i < 3; ++i) ball.hinges[i] = joint_called(name + "_" + std::to_string(i + 1));
      const std::string body = import::identifier(mj_id2name(&model, mjOBJ_BODY, model.jnt_bodyid[id]));
      for (int f = 0; f < tables_.frames.size; ++f)
        if (tables_.frames[f].name == body) ball.link_R_body = rotation(tables_.frames[f].rotation);
      balls_.push_back(ball);
    }
  }

  void run() {
    std::mt19937_64 engine(11);
    EXPECT_EQ(model_.nv, base_ + tables_.joints.size);
    for (int i = 0; i < kStates; ++i) {
      reference::Sample sample;
      const reference::AtLoops closed = reference::draw(engine, tables_, sample);
      compare(sample.motion, closed.robot(), reference::uniform_vector(engine, tables_.dof(), 5.0));
    }
  }

 private:
  struct Ball {
    int id = -1;
    std::array<int, 3> hinges;
    Matrix3d link_R_body;
  };

  // The joints of this project and the base, and MuJoCo's velocities as a function of their rates: v = T r.
  struct State {
    Matrix3d base = Matrix3d::Identity();
    VectorXd joints;
  };
  struct Velocities {
    MatrixXd T, K;  // K: MuJoCo's constraint Jacobian times T
  };

  numeric::InterpretedRobot robot_;
  reflection::Robot tables_;
  mjModel& model_;
  DataPointer data_;
  int base_;
  std::vector<std::pair<int, int>> scalars_;
  std::vector<Ball> balls_;

  static model::KinematicTree without_passive_forces(model::KinematicTree tree) {
    tree.uses_passive_forces = false;
    return tree;
  }

  int joint_called(const std::string& name) const {
    // A joint with the name of a body has a suffix.
    for (const std::string& called : {name, name + "_joint"})
      for (int j = 0; j < tables_.joints.size; ++j)
        if (tables_.joints[j].name == called) return j;
    throw std::runtime_error("no joint " + name);
  }

  // Sets MuJoCo's positions, and computes all that depends on them.
  Velocities at(const State& state) {
    Velocities result{MatrixXd::Zero(model_.nv, model_.nv), {}};
    mj_resetData(&model_, data_.get());
    if (base_ > 0) {
      const Eigen::Quaterniond q(state.base);
      const double pose[] = {0, 0, 0, q.w(), q.x(), q.y(), q.z()};
      std::copy(pose, pose + 7, data_->qpos);
      result.T.block<3, 3>(0, 3) = state.base;
      result.T.block<3, 3>(3, 0).setIdentity();
    }
    for (const auto& [id, joint] : scalars_) {
      data_->qpos[model_.jnt_qposadr[id]] = state.joints(joint);
      result.T(model_.jnt_dofadr[id], base_ + joint) = 1.0;
    }
    for (const Ball& ball : balls_) {
      // The body turns from its pose at zero, in axes of the body.
      Matrix3d turned = Matrix3d::Identity(), zero = Matrix3d::Identity();
      std::array<Matrix3d, 3> parent_R_child;
      for (std::size_t i = 0; i < 3; ++i) {
        const Matrix3d placed = rotation(tables_.joints[ball.hinges[i]].rotation);
        parent_R_child[i] = placed * Eigen::AngleAxisd(state.joints(ball.hinges[i]), Vector3d::UnitZ());
        turned = turned * parent_R_child[i];
        zero = zero * placed;
      }
      const Eigen::Quaterniond q(Matrix3d(ball.link_R_body.transpose() * zero.transpose() * turned * ball.link_R_body));
      const double elements[] = {q.w(), q.x(), q.y(), q.z()};
      std::copy(elements, elements + 4, data_->qpos + model_.jnt_qposadr[ball.id]);
      Matrix3d body_R_child = ball.link_R_body.transpose();
      for (std::size_t i = 3; i-- > 0;) {
        result.T.block<3, 1>(model_.jnt_dofadr[ball.id], base_ + ball.hinges[i]) = body_R_child.col(2);
        body_R_child = body_R_child * parent_R_child[i].transpose();
      }
    }
    mj_fwdPosition(&model_, data_.get());
    result.K = Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(data_->efc_J, data_->nefc, model_.nv) *
               result.T;
    return result;
  }

  static State moved(const State& state, const VectorXd& rates, double time, int base) {
    State result = state;
    result.joints += time * rates.tail(state.joints.size());
    if (base > 0 && rates.head<3>().norm() > 0)
      result.base = state.base * Eigen::AngleAxisd(time * rates.head<3>().norm(), rates.head<3>().normalized());
    return result;
  }

  // True for a rotation of a weld whose Jacobian is scaled by zero. MuJoCo before 3.0.1 does not scale its residual.
  bool has_no_torque(int row) const {
    const int id = data_->efc_id[row];
    if (model_.eq_type[id] != mjEQ_WELD || model_.eq_data[mjNEQDATA * id + 10] != 0) return false;
    const double* J = data_->efc_J + row * model_.nv;
    return std::all_of(J, J + model_.nv, [](double element) { return element == 0; });
  }

  void compare(
      const reference::Motion<double>& motion,
      const reference::Robot& linearised,
      const reference::Vector<double>& tau) {
    State state;
    state.joints = to_eigen(reference::joint_positions(linearised, motion.q));
    VectorXd rates(model_.nv);
    if (base_ > 0) rates.head<6>() = to_eigen(motion.base_velocity);
    rates.tail(tables_.joints.size) = to_eigen(reference::joint_rates(linearised, motion.qd));

    // dK/dt r and dT/dt r.
    constexpr double kStep = 1e-3;
    VectorXd K_change, T_change;
    for (const auto& [steps, weight] : {std::pair(1, 2.0 / 3), std::pair(2, -1.0 / 12)})
      for (const int sign : {1, -1}) {
        const Velocities near = at(moved(state, rates, sign * steps * kStep, base_));
        const VectorXd K_part = sign * weight / kStep * (near.K * rates),
                       T_part = sign * weight / kStep * (near.T * rates);
        K_change = K_change.size() == 0 ? K_part : K_change + K_part;
        T_change = T_change.size() == 0 ? T_part : T_change + T_part;
      }

    const auto [T, K] = at(state);
    for (int row = 0; row < data_->nefc; ++row)
      EXPECT_NEAR(has_no_torque(row) ? 0.0 : data_->efc_pos[row], 0.0, kClosed) << "row " << row;
    EXPECT_LT((K * rates).cwiseAbs().maxCoeff(), kClosed * std::max(1.0, rates.norm()));

    // r = G y with the coordinates y, of which the base is a part; the other joints follow.
    const int free = base_ + tables_.dof(), followers = model_.nv - free;
    ASSERT_GT(followers, 0);
    const MatrixXd of_followers = K.rightCols(followers);
    EXPECT_EQ(test::rank(of_followers, 1e-12), followers);
    MatrixXd G = MatrixXd::Identity(model_.nv, free);
    G.bottomRows(followers) = -test::least_squares(of_followers, K.leftCols(free));
    VectorXd added = VectorXd::Zero(model_.nv);
    added.tail(followers) = -test::least_squares(of_followers, K_change);
    EXPECT_LT((K * G).cwiseAbs().maxCoeff(), kClosed * std::max(1.0, K.cwiseAbs().maxCoeff()));

    const VectorXd velocity = T * rates;
    std::copy(velocity.begin(), velocity.end(), data_->qvel);
    mj_forward(&model_, data_.get());
    MatrixXd M(model_.nv, model_.nv);
    mj_fullM(&model_, M.data(), data_->qM);
    const MatrixXd H = G.transpose() * T.transpose() * M * T * G;
    expect_near("inertia matrix", to_eigen(robot_.joint_space_inertia(motion.q)), H);

    VectorXd force = VectorXd::Zero(free);
    force.tail(tables_.dof()) = to_eigen(tau);
    const VectorXd bias = Eigen::Map<const VectorXd>(data_->qfrc_bias, model_.nv);
    force -= G.transpose() * T.transpose() * (M * (T * added + T_change) + bias);
    const reference::Vector<double> gravity{model_.opt.gravity[0], model_.opt.gravity[1], model_.opt.gravity[2]};
    const VectorXd found = to_eigen(robot_.forward_dynamics(motion, tau, {&gravity, nullptr}));
    expect_near("acceleration", found, test::solved(H, force));
  }

  static void expect_near(const std::string& what, const MatrixXd& ours, const MatrixXd& theirs) {
    ASSERT_EQ(ours.rows(), theirs.rows());
    ASSERT_TRUE(ours.allFinite() && theirs.allFinite()) << what;
    EXPECT_LE((ours - theirs).cwiseAbs().maxCoeff(), kAgreement * theirs.cwiseAbs().maxCoeff()) << what;
  }
};

class MjcfLoopsTest : public testing::Test {
 public:
  explicit MjcfLoopsTest(path file) : file_(std::move(file)) {}

  void TestBody() override {
    const ModelPointer model = loaded(file_);
    model->opt.disableflags |= mjDSBL_LIMIT | mjDSBL_CONTACT | mjDSBL_FRICTIONLOSS | mjDSBL_ACTUATION | mjDSBL_PASSIVE;
    model->opt.jacobian = mjJAC_DENSE;
    const model::KinematicTree tree = imported(file_);
    Comparison(tree, *model).run();
    Comparison(converted(tree), *model).run();
  }

 private:
  path file_;
};

}  // namespace
}  // namespace robcogen::oracles

int main(int argc, char** argv) {
  using namespace robcogen::oracles;
  return run_tests_of_files(argc, argv, "mjcf_loops", [](const auto& file) { return new MjcfLoopsTest(file); });
}
