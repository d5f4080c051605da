// Mimic joints: the imported robot, whose coordinates are those of the other joints, compared with libraries that move
// all joints of the same file freely. With q = G y + c, read from the file by urdfdom, their results reduce to
//     tau_y = G' tau(G y + c, G yd, G ydd),   H_y = G' H G,   ydd = H_y^-1 (tau_y - bias_y),   J_y = J G.
#include <gtest/gtest.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <cstdio>
#include <fstream>

#include "imported.h"
#include "interpreted_robot.h"
#include "judge.h"
#include "linear_algebra.h"

namespace robcogen::oracles {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using model::KinematicTree;
using peers::Quantity;
using std::filesystem::path;

// Largest error relative to the largest element of the quantity. MuJoCo accepts a rotation to principal axes when its
// cosine is 1 - 1e-12, which is about 1e-6 rad.
constexpr double kAgreement = 1e-9, kPrincipalAxes = 1e-6;
constexpr int kStates = 20;
const Eigen::Vector3d kGravity(3, -1, 7);

// ---- The couplings of the file.

struct Reduction {
  MatrixXd G;
  VectorXd c;
};

// Returns a joint as a row of factors and an offset, following chains of mimic joints to their end.
std::pair<Eigen::RowVectorXd, double> row_of(
    const urdf::ModelInterface& robot,
    const std::string& joint,
    const std::vector<std::string>& independent) {
  if (!robot.getJoint(joint)) throw std::runtime_error("urdfdom finds no joint " + joint);
  const urdf::JointMimicSharedPtr mimic = robot.getJoint(joint)->mimic;
  if (mimic) {
    const auto [factors, offset] = row_of(robot, mimic->joint_name, independent);
    return {mimic->multiplier * factors, mimic->multiplier * offset + mimic->offset};
  }
  Eigen::RowVectorXd factors = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(independent.size()));
  const auto found = std::find(independent.begin(), independent.end(), joint);
  if (found == independent.end()) throw std::runtime_error(joint + " is not a coordinate of the robot");
  factors(found - independent.begin()) = 1;
  return {factors, 0};
}

Reduction reduction_of(
    const urdf::ModelInterface& robot,
    const std::vector<std::string>& all,
    const std::vector<std::string>& independent) {
  const auto rows = static_cast<Eigen::Index>(all.size());
  Reduction result{MatrixXd(rows, independent.size()), VectorXd(rows)};
  for (Eigen::Index j = 0; j < rows; ++j) {
    const auto [factors, offset] = row_of(robot, all[static_cast<std::size_t>(j)], independent);
    result.G.row(j) = factors;
    result.c(j) = offset;
  }
  return result;
}

MatrixXd with_base(const MatrixXd& G, bool floating) {
  if (!floating) return G;
  MatrixXd all = MatrixXd::Zero(6 + G.rows(), 6 + G.cols());
  all.topLeftCorner<6, 6>().setIdentity();
  all.bottomRightCorner(G.rows(), G.cols()) = G;
  return all;
}

// ---- The robot in both forms.

class MimicRobot {
 public:
  MimicRobot(path file, bool floating)
      : file_(std::move(file)),
        floating_(floating),
        tree_(imported(file_, floating, MimicJoints::coupled)),
        robot_(
            tree_,
            jacobians_of_leaves(tree_),
            numeric::all_steps(),
            {},
            {},
            {"inverse_dynamics", "forward_dynamics", "joint_space_inertia", "bias_forces", "jacobians"}),
        names_(changed_names(contents(file_))) {
    const urdf::ModelInterfaceSharedPtr model = urdf::parseURDFFile(file_.string());
    if (!model) throw std::runtime_error("urdfdom refuses " + file_.string());
    // A joint with the name of a link is imported under another name.
    const auto joint_name = [&](const model::Joint& joint) {
      const std::string name = urdf_name(joint.name), suffix = "_joint";
      return model->getJoint(name) || !name.ends_with(suffix) ? name : name.substr(0, name.size() - suffix.size());
    };
    const KinematicTree free = imported(file_, floating, MimicJoints::free);
    for (const model::Joint& joint : free.joints) all_.push_back(joint_name(joint));
    std::vector<std::string> independent;
    for (const int j : tree_.coordinates())
      independent.push_back(joint_name(tree_.joints[static_cast<std::size_t>(j)]));
    reduction_ = reduction_of(*model, all_, independent);
    std::mt19937_64 engine(37);
    for (int i = 0; i < kStates; ++i) {
      motions_.push_back(reference::random_sample(engine, robot_.tables()).motion);
      forces_.push_back(reference::uniform_vector(engine, tree_.dof(), 20));
    }
  }

  int coupled() const { return static_cast<int>(all_.size()) - tree_.dof(); }

  // Compares everything that a library has; false if it does not read the file.
  bool agrees_with(const std::string& library, double tolerance) {
    const auto peer = load(library, kGravity, "");
    if (!peer) return false;
    std::printf("%s:", library.c_str());
    if (has("inverse_dynamics")) compare_dynamics(*peer, tolerance);
    compare_jacobians(library);
    std::printf("\n");
    return true;
  }

 private:
  path file_;
  bool floating_;
  KinematicTree tree_;
  numeric::InterpretedRobot robot_;
  std::map<std::string, std::string> names_;
  std::vector<std::string> all_;  // joints, as they are called in the file
  Reduction reduction_;
  std::vector<reference::Motion<double>> motions_;
  std::vector<reference::Vector<double>> forces_;

  std::string urdf_name(const std::string& name) const {
    const auto found = names_.find(name);
    return found == names_.end() ? name : found->second;
  }

  std::unique_ptr<peers::Peer> load(const std::string& library, const Eigen::Vector3d& gravity, const std::string& link)
      const {
    for (peers::Candidate& candidate : peers::load({file_.string(), all_, floating_, gravity, link}))
      if (candidate.library == library) return std::move(candidate.peer);
    return nullptr;
  }

  // Sets the state of the free robot.
  void prepare(peers::Peer& peer, const reference::Motion<double>& m) const {
    const auto none = VectorXd::Zero(static_cast<Eigen::Index>(all_.size()));
    const VectorXd q = reduction_.G * to_eigen(m.q) + reduction_.c;
    peer.prepare(
        {{q, reduction_.G * to_eigen(m.qd), reduction_.G * to_eigen(m.qdd), none, to_eigen(m.base_velocity),
          to_eigen(m.base_acceleration)}});
  }

  VectorXd forces_of(peers::Peer& peer, const reference::Motion<double>& m) const {
    prepare(peer, m);
    peer.run(Quantity::inverse_dynamics, 0);
    return peer.result(Quantity::inverse_dynamics);
  }

  static double error(const MatrixXd& found, const MatrixXd& expected) {
    EXPECT_EQ(found.rows(), expected.rows());
    EXPECT_TRUE(found.allFinite() && expected.allFinite());
    return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
  }

  // Robots without mass, or with parts without mass, lack some functions.
  bool has(const std::string& function) const { return robot_.has(function); }

  static void expect(const char* what, double error, double tolerance) {
    std::printf(" %s %.1e", what, error);
    EXPECT_LE(error, tolerance) << what;
  }

  void compare_dynamics(peers::Peer& peer, double tolerance) const {
    const MatrixXd G = with_base(reduction_.G, floating_);
    const reference::Vector<double> gravity{kGravity[0], kGravity[1], kGravity[2]};
    const reference::Arguments arguments{&gravity, nullptr};
    const bool has_inertia = peer.has(Quantity::inertia_matrix);
    double of_tau = 0, of_bias = 0, of_H = 0, of_qdd = 0;
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      const reference::Motion<double>& m = motions_[i];
      reference::Motion<double> at_rest = m;
      at_rest.qdd = 0.0 * m.qdd;
      at_rest.base_acceleration = 0.0 * m.base_acceleration;
      const VectorXd tau = G.transpose() * forces_of(peer, m), bias = G.transpose() * forces_of(peer, at_rest);
      of_tau = std::max(of_tau, error(to_eigen(robot_.inverse_dynamics_fully_actuated(m, arguments)), tau));
      of_bias = std::max(of_bias, error(to_eigen(robot_.bias_forces(m, arguments)), bias));
      if (!has_inertia) continue;
      peer.run(Quantity::inertia_matrix, 0);
      const MatrixXd H = G.transpose() * peer.result(Quantity::inertia_matrix) * G;
      of_H = std::max(of_H, error(to_eigen(robot_.joint_space_inertia(m.q)), H));
      if (!has("forward_dynamics")) continue;
      VectorXd missing = -bias;
      missing.tail(tree_.dof()) += to_eigen(forces_[i]);
      const VectorXd qdd = test::solved(H, missing);
      of_qdd = std::max(of_qdd, error(to_eigen(robot_.forward_dynamics(m, forces_[i], arguments)), qdd));
    }
    expect("inverse dynamics", of_tau, tolerance);
    expect("bias forces", of_bias, tolerance);
    if (has_inertia) expect("inertia matrix", of_H, tolerance);
    if (has_inertia && has("forward_dynamics")) expect("forward dynamics", of_qdd, tolerance);
  }

  // Compares the Jacobians of all leaves.
  void compare_jacobians(const std::string& library) const {
    double worst = 0;
    const reflection::Robot tables = robot_.tables();
    for (int k = 0; k < tables.jacobians.size; ++k) {
      const reflection::Jacobian& jacobian = tables.jacobians[k];
      const auto peer = load(library, kGravity, urdf_name(tables.frames[jacobian.right].name));
      ASSERT_TRUE(peer && peer->has(Quantity::jacobian)) << tables.frames[jacobian.right].name;
      for (const reference::Motion<double>& m : motions_) {
        prepare(*peer, m);
        peer->run(Quantity::jacobian, 0);
        const MatrixXd expected = peer->result(Quantity::jacobian) * reduction_.G;
        const MatrixXd narrow = to_eigen(robot_.jacobian(k, m.q));
        MatrixXd J = MatrixXd::Zero(6, tree_.dof());
        for (int i = 0; i < jacobian.column_count; ++i) J.col(jacobian.columns[i]) = narrow.col(i);
        worst = std::max(worst, error(J, expected));
      }
    }
    expect("Jacobians", worst, kAgreement);
  }
};

const path kModels = ROBCOGEN_MODELS_DIR, kUrdfs = ROBCOGEN_URDFS_DIR;
const path kOwn = path(TEST_SOURCE_DIR) / "mimic_tree.urdf";

// True if the library must judge. A library that may be missing, and is, judges nothing.
bool is_installed(const std::string& library) {
  for (const peers::Candidate& candidate : peers::load({kOwn.string(), {}, false, {0, 0, -9.81}, ""}))
    if (candidate.library == library) return candidate.installed || (REQUIRE_ORACLES && library != "DART");
  return true;
}

void expect_reduction(const path& file, bool floating, int coupled, const std::vector<std::string>& libraries) {
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  MimicRobot robot(file, floating);
  EXPECT_EQ(robot.coupled(), coupled);
  for (const std::string& library : libraries) {
    const bool is_there = robot.agrees_with(library, library == "MuJoCo" ? kPrincipalAxes : kAgreement);
    EXPECT_TRUE(is_there || !is_installed(library)) << library << " does not read " << file;
  }
}

// A changed URDF, for libraries that read files.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : name_(path(testing::TempDir()) / ("robcogen_mimic_" + name + ".urdf")) {
    std::ofstream(name_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(name_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const path& name() const { return name_; }

 private:
  path name_;
};

TEST(MimicJoints, OfATreeWithChains) {
  expect_reduction(kOwn, false, 4, {"KDL", "DART", "MuJoCo"});
}

TEST(MimicJoints, OfPandasFingers) {
  expect_reduction(kModels / "panda.urdf", false, 1, {"KDL", "DART", "MuJoCo"});
}

// The reduced Talos, whose fingers mimic the joints of the grippers but are fixed: returns it with fingers that move.
std::string with_moving_fingers(std::string urdf) {
  const std::string fixed = "type=\"fixed\"";
  for (std::size_t at = urdf.find("<mimic "); at != std::string::npos; at = urdf.find("<mimic ", at + 1)) {
    const std::size_t joint = urdf.rfind("<joint ", at);
    const std::size_t type = urdf.find(fixed, joint);
    if (type < urdf.find('>', joint)) urdf.replace(type, fixed.size(), "type=\"revolute\"");
  }
  return urdf;
}

// MuJoCo refuses some inertia tensors of the file.
TEST(MimicJoints, OfTalosGrippers) {
  const path file = kModels / "talos_reduced.urdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  const TemporaryFile changed("talos", with_moving_fingers(contents(file)));
  expect_reduction(changed.name(), false, 12, {"KDL", "DART"});
  expect_reduction(changed.name(), true, 12, {"DART"});
}

// The file has no mimic joints. In hands of this kind the last joint of a finger follows the one before it.
TEST(MimicJoints, OfAllegroWithCoupledFingers) {
  const path file = kModels / "allegro_left_hand.urdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  std::string urdf = contents(file);
  for (const auto& [tip, middle] : {std::pair("3.0", "2.0"), std::pair("7.0", "6.0"), std::pair("11.0", "10.0")}) {
    const std::string start = std::string("<joint name=\"joint_") + tip + "\"";
    const std::size_t at = urdf.find(start);
    ASSERT_NE(at, std::string::npos) << start;
    const std::size_t end = urdf.find('>', at) + 1;
    urdf.insert(end, std::string("<mimic joint=\"joint_") + middle + "\" multiplier=\"0.8\" offset=\"0.05\"/>");
  }
  expect_reduction(TemporaryFile("allegro", urdf).name(), false, 3, {"KDL", "DART"});
}

// All other files, each compared with at least one library.
TEST(MimicJoints, OfRobotsFromTheField) {
  int robots = 0;
  for (const path& file : urdfs_in({kUrdfs})) {
    if (contents(file).find("<mimic") == std::string::npos) continue;
    SCOPED_TRACE(file.filename().string());
    std::printf("%s\n", file.filename().c_str());
    MimicRobot robot(file, false);
    int libraries = 0;
    for (const char* library : {"KDL", "DART"}) libraries += robot.agrees_with(library, kAgreement) ? 1 : 0;
    EXPECT_TRUE(libraries > 0 || !is_installed("DART"));
    ++robots;
  }
  if (robots == 0) GTEST_SKIP() << "no URDFs with mimic joints in " << kUrdfs;
}

}  // namespace
}  // namespace robcogen::oracles

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
