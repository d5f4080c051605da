// The import of MJCF: the imported robot, and its robot document when read again, run in the interpreter and compared
// with MuJoCo on the same file. The files are those of the folder mjcf, and those that the program's arguments name.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include "algorithm/kinematics/collision.h"
#include "interpreted_robot.h"
#include "judge.h"
#include "linear_algebra.h"
#include "mjcf_files.h"
#include "model/collision.h"
#include "symbolic/interpret.h"

namespace robcogen::oracles {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using model::Frame;
using model::KinematicTree;
using std::filesystem::path;

// Relative to the largest element, for two programs in double precision.
constexpr double kAgreement = 1e-9;
// MuJoCo accepts a rotation to principal axes when its cosine is 1 - 1e-12.
constexpr double kPrincipalAxes = 1e-6;
// MuJoCo 2 rounds the vertices of a mesh to single precision once more, in the axes of its inertia.
constexpr double kVertices = 1e-6;
constexpr int kStates = 50;
constexpr std::uint64_t kSeed = 17;

// Whether the constraint is active in the file.
bool is_active(const mjModel& model, int constraint) {
#if mjVERSION_HEADER >= 300
  return model.eq_active0[constraint] != 0;
#else
  return model.eq_active[constraint] != 0;
#endif
}

// Transforms from the base to every user frame.
model::DesiredTransforms to_user_frames(const KinematicTree& tree) {
  model::DesiredTransforms desired;
  const std::vector<Frame> frames = tree.frames();
  for (const Frame& frame : frames)
    if (frame.kind == Frame::Kind::user) desired.transforms.push_back({frames.front(), frame});
  return desired;
}

class MjcfTest : public testing::Test {
 public:
  explicit MjcfTest(path file) : file_(std::move(file)) {}

  void TestBody() override {
    model_ = loaded(file_);
    model_->opt.disableflags |= mjDSBL_CONSTRAINT | mjDSBL_ACTUATION;
    data_.reset(mj_makeData(model_.get()));
    const KinematicTree tree = imported(file_);
    compare(tree);
    compare(converted(tree));
  }

 private:
  void compare(const KinematicTree& tree) {
    floating_ = tree.floating_base;
    ASSERT_EQ(model_->nv, static_cast<int>(tree.joints.size()) + base());
    find_couplings(tree);
    const numeric::InterpretedRobot robot(tree, to_user_frames(tree));
    std::mt19937_64 engine(kSeed);
    for (int i = 0; i < kStates; ++i) {
      const reference::Motion<double> motion = reference::random_sample(engine, robot.tables()).motion;
      compare(robot, motion, reference::uniform_vector(engine, tree.dof(), 20.0));
      if (i == 0 && !tree.geometry.shapes.empty()) compare_shapes(tree, motion.q);
    }
  }

  int base() const { return floating_ ? 6 : 0; }

  // The velocities v of MuJoCo's joints, the base first, follow from those of the coordinates: v = G y. In MuJoCo
  // couplings are constraints; here they are read from its tables.
  void find_couplings(const KinematicTree& tree) {
    const int n = base() + tree.dof();
    G_ = MatrixXd::Zero(model_->nv, n);
    offsets_ = VectorXd::Zero(model_->nv);
    G_.topLeftCorner(base(), base()).setIdentity();
    for (int i = 0; i < tree.dof(); ++i) {
      const std::string& name =
          tree.joints[static_cast<std::size_t>(tree.coordinates()[static_cast<std::size_t>(i)])].name;
      const int joint = tree.couplings.empty() ? -1 : mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str());
      G_(joint < 0 ? base() + i : model_->jnt_dofadr[joint], base() + i) = 1.0;
    }
    // Repeated as often as the longest possible chain of couplings requires.
    for (int k = 0; k < model_->neq * model_->neq; ++k) {
      const int i = k % model_->neq, joint = model_->eq_obj1id[i], followed = model_->eq_obj2id[i];
      if (tree.couplings.empty() || model_->eq_type[i] != mjEQ_JOINT || !is_active(*model_, i)) continue;
      const mjtNum* a = model_->eq_data + i * mjNEQDATA;
      const int row = model_->jnt_dofadr[joint];
      offsets_(row) = a[0] + model_->qpos0[model_->jnt_qposadr[joint]];
      if (followed < 0) continue;
      const int other = model_->jnt_dofadr[followed];
      G_.row(row) = a[1] * G_.row(other);
      offsets_(row) += a[1] * (offsets_(other) - model_->qpos0[model_->jnt_qposadr[followed]]);
    }
  }

  // Returns one element per velocity: the scalar parts of quaternions are left out.
  static VectorXd coordinates(const reflection::Robot& tables, const VectorXd& q) {
    VectorXd result(tables.dof());
    for (int j = 0; j < tables.dof(); ++j) result(j) = q(tables.position_of(j));
    return result;
  }

  VectorXd full(const VectorXd& joints) const { return G_.rightCols(joints.size()) * joints; }

  // The base is at the origin, and its axes are those of the world. MuJoCo has the velocity of the origin first, then
  // the angular velocity.
  void set_state(
      const reflection::Robot& tables,
      const reference::Motion<double>& m,
      const reference::Vector<double>& tau) {
    mj_resetData(model_.get(), data_.get());
    const VectorXd base = to_eigen(m.base_velocity), force = to_eigen(tau);
    const VectorXd q = full(coordinates(tables, to_eigen(m.q))) + offsets_;
    const VectorXd qd = full(to_eigen(m.qd)).tail(model_->nv - this->base());
    if (floating_) {
      std::fill(data_->qpos, data_->qpos + 7, 0.0);
      data_->qpos[3] = 1.0;
      for (int k = 0; k < 3; ++k) data_->qvel[k] = base(k + 3), data_->qvel[k + 3] = base(k);
    }
    // Ball joints are in the order of the file in both programs.
    std::vector<int> quaternions;
    for (int j = 0; j < tables.dof(); ++j)
      if (tables.joints[j].type == JointType::spherical && !tables.is_follower(j))
        quaternions.push_back(tables.position_of(j) - 1);
    auto quaternion = quaternions.begin();
    for (int joint = floating_ ? 1 : 0; joint < model_->njnt; ++joint) {
      const int element = model_->jnt_qposadr[joint];
      if (model_->jnt_type[joint] != mjJNT_BALL) {
        data_->qpos[element] = q(model_->jnt_dofadr[joint]);
        continue;
      }
      ASSERT_NE(quaternion, quaternions.end());
      for (int k = 0; k < 4; ++k) data_->qpos[element + k] = m.q(*quaternion + k);
      ++quaternion;
    }
    std::copy(qd.begin(), qd.end(), data_->qvel + (floating_ ? 6 : 0));
    if (G_.rows() == G_.cols()) std::copy(force.begin(), force.end(), data_->qfrc_applied + (floating_ ? 6 : 0));
  }

  // Moves the angular part to the front.
  VectorXd reordered(const mjtNum* vector) const {
    VectorXd result = Eigen::Map<const VectorXd>(vector, model_->nv);
    if (floating_) result.head<3>().swap(result.segment<3>(3));
    return result;
  }

  MatrixXd inertia() const {
    MatrixXd H(model_->nv, model_->nv);
    mj_fullM(model_.get(), H.data(), data_->qM);
    if (!floating_) return H;
    H.topRows<3>().swap(H.middleRows<3>(3));
    H.leftCols<3>().swap(H.middleCols<3>(3));
    return H;
  }

  void compare(
      const numeric::InterpretedRobot& robot,
      const reference::Motion<double>& motion,
      const reference::Vector<double>& tau) {
    set_state(robot.tables(), motion, tau);
    mj_forward(model_.get(), data_.get());
    const Vector3d g = Eigen::Map<const Vector3d>(model_->opt.gravity);
    const reference::Vector<double> gravity{g(0), g(1), g(2)};
    const reference::Arguments arguments{&gravity, nullptr};

    // The classical acceleration of the base's origin differs from the spatial one (Featherstone 2008, sec. 2.11).
    VectorXd excess = VectorXd::Zero(G_.cols());
    const VectorXd velocity = to_eigen(motion.base_velocity);
    if (floating_) excess.segment<3>(3) = Vector3d(velocity.head<3>()).cross(Vector3d(velocity.tail<3>()));

    const MatrixXd H = to_eigen(robot.joint_space_inertia(motion.q));
    expect_near("inertia matrix", H, G_.transpose() * inertia() * G_);
    // Friction is a constraint in MuJoCo, and constraints are off.
    VectorXd friction(model_->nv);
    for (int i = 0; i < model_->nv; ++i)
      friction(i) = model_->dof_frictionloss[i] * (data_->qvel[i] > 0 ? 1.0 : data_->qvel[i] < 0 ? -1.0 : 0.0);
    const VectorXd bias = to_eigen(robot.bias_forces(motion, arguments));
    const VectorXd theirs = G_.transpose() * (reordered(data_->qfrc_bias) - reordered(data_->qfrc_passive));
    const VectorXd lost = G_.transpose() * friction;
    expect_near("bias forces", bias, theirs + lost + H * excess);
    // The friction is subtracted from the forces.
    reference::Vector<double> applied = tau;
    for (int j = 0; j < tau.rows(); ++j) applied(j) += lost(j + base());
    const VectorXd acceleration = to_eigen(robot.forward_dynamics(motion, applied, arguments));
    VectorXd expected = VectorXd::Zero(G_.cols());
    if (G_.rows() == G_.cols()) {
      expected = reordered(data_->qacc);
    } else {
      expected.tail(tau.rows()) = to_eigen(tau);
      expected = test::solved(G_.transpose() * inertia() * G_, expected - theirs);
    }
    expect_near("acceleration", acceleration, expected - excess);
    compare_frames(robot, motion.q);
  }

  void compare_frames(const numeric::InterpretedRobot& robot, const reference::Vector<double>& q) {
    const reflection::Robot tables = robot.tables();
    for (int i = 0; i < tables.transforms.size; ++i) {
      const char* name = tables.frames[tables.transforms[i].right].name;
      const int body = mj_name2id(model_.get(), mjOBJ_BODY, name), site = mj_name2id(model_.get(), mjOBJ_SITE, name);
      if (body < 0 && site < 0) continue;
      const mjtNum* position = body >= 0 ? data_->xpos + 3 * body : data_->site_xpos + 3 * site;
      const mjtNum* rotation = body >= 0 ? data_->xmat + 9 * body : data_->site_xmat + 9 * site;
      MatrixXd pose = MatrixXd::Identity(4, 4);
      pose.topLeftCorner<3, 3>() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation);
      pose.topRightCorner<3, 1>() = Eigen::Map<const Vector3d>(position);
      expect_near(name, to_eigen(robot.transform(i, q).homogeneous), pose);
    }
  }

  // The geoms of bodies, which are in the same order, have the capsules that the model makes of them.
  void compare_shapes(const KinematicTree& tree, const reference::Vector<double>& q) {
    const std::vector<model::Capsule> capsules = model::capsules(tree);
    const VectorXd positions = to_eigen(q);
    const symbolic::Arrays<double> arguments = {{"q", {positions.begin(), positions.end()}}};
    std::vector<double> spheres, others;
    if (std::any_of(capsules.begin(), capsules.end(), [](const auto& c) { return c.is_sphere(); }))
      spheres = symbolic::interpret<double>(algorithm::collision_spheres(tree, "s"), arguments).at("centers");
    if (std::any_of(capsules.begin(), capsules.end(), [](const auto& c) { return !c.is_sphere(); }))
      others = symbolic::interpret<double>(algorithm::collision_capsules(tree, "c"), arguments).at("ends");
    std::map<std::string, std::vector<int>> geoms;
    for (int g = 0; g < model_->ngeom; ++g) {
      const bool is_checked = model_->geom_contype[g] != 0 || model_->geom_conaffinity[g] != 0;
      if (!is_checked || model_->geom_type[g] == mjGEOM_PLANE) continue;
      const int body = model_->geom_bodyid[g];
      const char* name = mj_id2name(model_.get(), mjOBJ_BODY, body);
      geoms[name == nullptr || *name == 0 ? "body_" + std::to_string(body) : name].push_back(g);
    }
    std::map<std::string, std::size_t> next;
    std::size_t sphere = 0, other = 0;
    for (const model::Capsule& capsule : capsules) {
      const double* first = capsule.is_sphere() ? spheres.data() + 3 * sphere++ : others.data() + 6 * other++;
      const Vector3d a = Eigen::Map<const Vector3d>(first),
                     b = Eigen::Map<const Vector3d>(capsule.is_sphere() ? first : first + 3);
      const std::vector<int>& of_body = geoms[capsule.body];
      ASSERT_LT(next[capsule.body], of_body.size()) << capsule.name;
      compare_shape(capsule, a, b, of_body[next[capsule.body]++]);
    }
    for (const auto& [body, list] : geoms) EXPECT_EQ(next[body], list.size()) << body;
  }

  void compare_shape(const model::Capsule& capsule, const Vector3d& a, const Vector3d& b, int geom) {
    SCOPED_TRACE(capsule.name);
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> R =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->geom_xmat + 9 * geom);
    const Vector3d center = Eigen::Map<const Vector3d>(data_->geom_xpos + 3 * geom);
    const mjtNum* size = model_->geom_size + 3 * geom;
    const int type = model_->geom_type[geom];
    std::vector<Vector3d> points;  // that the capsule contains, the farthest of which is on its surface
    if (type == mjGEOM_BOX) {
      for (int k = 0; k < 8; ++k)
        points.push_back(
            center + R * Vector3d(k & 1 ? size[0] : -size[0], k & 2 ? size[1] : -size[1], k & 4 ? size[2] : -size[2]));
    } else if (type == mjGEOM_MESH) {
      const int mesh = model_->geom_dataid[geom];
      for (int k = 0; k < model_->mesh_vertnum[mesh]; ++k)
        points.push_back(
            center + R * Eigen::Map<const Eigen::Vector3f>(model_->mesh_vert + 3 * (model_->mesh_vertadr[mesh] + k))
                             .cast<double>());
    } else {
      double radius = size[0], half = type == mjGEOM_SPHERE ? 0 : size[1];
      int axis = 2;
      if (type == mjGEOM_ELLIPSOID) {
        axis = static_cast<int>(std::max_element(size, size + 3) - size);
        radius = std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
        half = size[axis] - radius;
      }
      const Vector3d along = half * R.col(axis);
      EXPECT_NEAR(capsule.radius, radius, kAgreement);
      EXPECT_LE(std::min((a - center - along).norm(), (a - center + along).norm()), kAgreement);
      EXPECT_LE((a + b - 2 * center).norm(), kAgreement);
      EXPECT_NEAR((a - b).norm(), 2 * half, kAgreement);
      return;
    }
    double farthest = 0;
    for (const Vector3d& p : points) {
      const Vector3d d = b - a;
      const double t = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
      farthest = std::max(farthest, (p - a - t * d).norm());
    }
    EXPECT_NEAR(farthest, capsule.radius, kVertices);
  }

  void expect_near(const std::string& what, const MatrixXd& ours, const MatrixXd& theirs) const {
    const double tolerance = file_.stem() == "tensor"   ? kPrincipalAxes
                             : file_.stem() == "meshes" ? kVertices
                                                        : kAgreement;
    ASSERT_EQ(ours.rows(), theirs.rows());
    ASSERT_TRUE(ours.allFinite() && theirs.allFinite());
    const double scale = std::max(theirs.cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_LE((ours - theirs).cwiseAbs().maxCoeff(), scale * tolerance) << what;
  }

  path file_;
  bool floating_ = false;
  MatrixXd G_;
  VectorXd offsets_;
  ModelPointer model_;
  DataPointer data_;
};

}  // namespace
}  // namespace robcogen::oracles

int main(int argc, char** argv) {
  using namespace robcogen::oracles;
  return run_tests_of_files(argc, argv, "mjcf", [](const auto& file) { return new MjcfTest(file); });
}
