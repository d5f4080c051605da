// The imported robot compared with urdfdom on the same text: poses of all links, inertia matrix and gravity forces as
// sums over the links, in dense matrices of doubles. The oracle uses nothing of tool/import and no algorithm of
// tool/algorithm.
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <random>

#include "algorithm/catalogue/catalogue.h"
#include "pass/passes.h"
#include "random_urdf.h"
#include "reading.h"
#include "symbolic/interpret.h"

namespace robcogen::oracle_test {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Rounding errors of dozens of products along a chain, relative to the largest element.
constexpr double kRounding = 1e-12;

// --- the oracle --------------------------------------------------------------------------------------------------

Isometry3d pose(const urdf::Pose& p) {
  Isometry3d X = Isometry3d::Identity();
  const urdf::Rotation& r = p.rotation;
  X.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  X.translation() << p.position.x, p.position.y, p.position.z;
  return X;
}

struct Dense {
  std::map<std::string, Isometry3d> poses;  // of all links, in the frame of the base
  MatrixXd H;                               // (6 + n) or n rows; base first, angular part first
  VectorXd G;                               // the joint forces that hold the robot against gravity
  double weight_times_reach = 0.0;          // an upper bound of G
};

class Oracle {
 public:
  // `q` is given by joint name; `joints` is in the order of the columns.
  Oracle(
      const urdf::ModelInterface& robot,
      const std::string& base,
      const std::vector<std::string>& joints,
      const std::map<std::string, double>& q,
      bool floating,
      const Vector3d& gravity)
      : q_(q), gravity_(gravity), first_(floating ? 6 : 0) {
    for (std::size_t i = 0; i < joints.size(); ++i) column_[joints[i]] = first_ + static_cast<int>(i);
    const auto n = first_ + static_cast<int>(joints.size());
    result_.H = MatrixXd::Zero(n, n);
    result_.G = VectorXd::Zero(n);
    MatrixXd none = MatrixXd::Zero(6, n);
    if (floating) none.leftCols(6).setIdentity();
    visit(*robot.getLink(base), Isometry3d::Identity(), none);
  }

  Dense result() const { return result_; }

 private:
  // J maps to the velocity of the link at the origin of the base, angular first, in base axes.
  void visit(const urdf::Link& link, const Isometry3d& X, const MatrixXd& J) {
    result_.poses[link.name] = X;
    if (link.inertial && J.cols() > 0) add(*link.inertial, X, J);
    for (const auto& joint : link.child_joints) {
      Isometry3d child = X * pose(joint->parent_to_joint_origin_transform);
      MatrixXd child_J = J;
      const auto found = column_.find(joint->name);
      if (found != column_.end()) {
        const Vector3d own = Vector3d(joint->axis.x, joint->axis.y, joint->axis.z).normalized();
        const Vector3d axis = child.linear() * own;
        const double q = q_.at(joint->name);
        if (joint->type == urdf::Joint::PRISMATIC) {
          child_J.col(found->second) << Vector3d::Zero(), axis;
          child = child * Eigen::Translation3d(q * own);
        } else {
          child_J.col(found->second) << axis, child.translation().cross(axis);
          child = child * Eigen::AngleAxisd(q, own);
        }
      }
      visit(*joint_child(link, joint->child_link_name), child, child_J);
    }
  }

  static const urdf::Link* joint_child(const urdf::Link& link, const std::string& name) {
    for (const auto& child : link.child_links)
      if (child->name == name) return child.get();
    return nullptr;
  }

  void add(const urdf::Inertial& inertial, const Isometry3d& X, const MatrixXd& J) {
    const Isometry3d C = X * pose(inertial.origin);
    const Vector3d c = C.translation();
    Matrix3d I;
    I << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy, inertial.iyz, inertial.ixz, inertial.iyz,
        inertial.izz;
    const MatrixXd Jw = J.topRows(3);
    MatrixXd Jc = J.bottomRows(3);
    for (Eigen::Index k = 0; k < J.cols(); ++k) Jc.col(k) += Vector3d(Jw.col(k)).cross(c);
    const Matrix3d I_base = C.linear() * I * C.linear().transpose();
    result_.H += inertial.mass * Jc.transpose() * Jc + Jw.transpose() * I_base * Jw;
    result_.G -= Jc.transpose() * (inertial.mass * gravity_);
    result_.weight_times_reach += inertial.mass * gravity_.norm() * (1.0 + c.norm());
  }

  const std::map<std::string, double>& q_;
  Vector3d gravity_;
  int first_;
  std::map<std::string, int> column_;
  Dense result_;
};

// --- the imported robot ------------------------------------------------------------------------------------------

Isometry3d pose(const model::Placement& p) {
  const auto value = [](const model::Quantity& q) { return model::evaluate(q); };
  Isometry3d X = Isometry3d::Identity();
  X.translation() << value(p.translation[0]), value(p.translation[1]), value(p.translation[2]);
  for (int k = 0; k < 3; ++k)
    X = X * Eigen::AngleAxisd(value(p.rotation[static_cast<std::size_t>(k)]), Vector3d::Unit(k));
  return X;
}

std::map<std::string, Isometry3d> frames_of(const model::KinematicTree& tree, const VectorXd& q) {
  std::vector<Isometry3d> links(tree.links.size(), Isometry3d::Identity());
  for (const int j : tree.topological()) {
    const model::Joint& joint = tree.joints[static_cast<std::size_t>(j)];
    Isometry3d X = links[static_cast<std::size_t>(joint.parent)] * pose(joint.placement);
    if (joint.type == model::JointType::prismatic) {
      X = X * Eigen::Translation3d(0, 0, q[j]);
    } else {
      X = X * Eigen::AngleAxisd(q[j], Vector3d::UnitZ());
    }
    links[static_cast<std::size_t>(joint.child)] = X;
  }
  std::map<std::string, Isometry3d> frames;
  for (const model::UserFrame& f : tree.user_frames)
    frames[f.name] = links[static_cast<std::size_t>(f.link)] * pose(f.placement);
  return frames;
}

std::vector<double> values(const VectorXd& v) {
  return {v.data(), v.data() + v.size()};
}

class Interpreted {
 public:
  explicit Interpreted(const model::KinematicTree& tree) : tree_(tree) {
    for (const char* group : {"joint_space_inertia", "bias_forces"}) {
      for (symbolic::Function& f : algorithm::functions(tree, {}, group)) {
        const std::string name = f.program.name;
        programs_.emplace(name, pass::run(std::move(f.program)));
      }
    }
  }

  MatrixXd inertia_matrix(const VectorXd& q) const {
    const std::vector<double> h =
        symbolic::interpret(programs_.at("joint_space_inertia"), inputs({{"q", values(q)}}, "joint_space_inertia"))
            .at("H");
    const auto n = tree_.dof() + (tree_.floating_base ? 6 : 0);
    return Eigen::Map<const MatrixXd>(h.data(), n, n);
  }

  VectorXd gravity_forces(const VectorXd& q, const Vector3d& gravity) const {
    const std::string name = tree_.floating_base ? "gravity_forces" : "gravity_forces_gravity";
    const symbolic::Arrays<double> found =
        symbolic::interpret(programs_.at(name), inputs({{"q", values(q)}, {"gravity", values(gravity)}}, name));
    std::vector<double> all = tree_.floating_base ? found.at("base_wrench") : std::vector<double>();
    all.insert(all.end(), found.at("tau").begin(), found.at("tau").end());
    return Eigen::Map<const VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
  }

 private:
  symbolic::Arrays<double> inputs(symbolic::Arrays<double> given, const std::string& program) const {
    std::erase_if(given, [&](const auto& array) {
      const auto& wanted = programs_.at(program).inputs;
      return std::none_of(wanted.begin(), wanted.end(), [&](const auto& input) { return input.name == array.first; });
    });
    return given;
  }

  const model::KinematicTree& tree_;
  std::map<std::string, symbolic::Program> programs_;
};

// --- the comparison ----------------------------------------------------------------------------------------------

std::string plain(const std::string& name) {
  std::string result = name;
  for (char& c : result)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return result;
}

// urdfdom requires limits, which have no meaning here.
std::string with_limits(std::string text) {
  const std::string limit = R"(<limit effort="1" velocity="1"/>)", end = "</joint>";
  for (std::size_t at = 0; (at = text.find(end, at)) != std::string::npos; at += limit.size() + end.size())
    text.insert(at, limit);
  return text;
}

void expect_agreement(const std::string& text, const model::KinematicTree& tree, double tolerance = kRounding) {
  const urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(with_limits(text));
  ASSERT_TRUE(robot);
  std::vector<std::string> joints;
  for (const model::Joint& joint : tree.joints) {
    for (const auto& [name, theirs] : robot->joints_)
      if (plain(name) == joint.name) joints.push_back(name);
  }
  ASSERT_EQ(joints.size(), tree.joints.size());
  const Interpreted interpreted(tree);
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  for (int state = 0; state < 3; ++state) {
    VectorXd q(tree.dof());
    std::map<std::string, double> named;
    for (int j = 0; j < tree.dof(); ++j) named[joints[static_cast<std::size_t>(j)]] = q[j] = any(engine);
    const Vector3d gravity(any(engine), any(engine), -9.81);
    const Dense wanted = Oracle(*robot, robot->getRoot()->name, joints, named, tree.floating_base, gravity).result();

    const std::map<std::string, Isometry3d> frames = frames_of(tree, q);
    ASSERT_EQ(frames.size(), wanted.poses.size());
    for (const auto& [name, X] : wanted.poses) {
      const auto found = frames.find(plain(name));
      ASSERT_TRUE(found != frames.end()) << name;
      const double size = 1.0 + X.translation().norm();
      EXPECT_LT((found->second.matrix() - X.matrix()).cwiseAbs().maxCoeff(), tolerance * size) << "frame " << name;
    }
    if (wanted.H.size() == 0) continue;
    EXPECT_LT(
        (interpreted.inertia_matrix(q) - wanted.H).cwiseAbs().maxCoeff(), tolerance * wanted.H.cwiseAbs().maxCoeff());
    EXPECT_LT(
        (interpreted.gravity_forces(q, gravity) - wanted.G).cwiseAbs().maxCoeff(),
        tolerance * wanted.weight_times_reach);
  }
}

constexpr std::uint64_t kSeeds = 100;

TEST(Oracle, AgreesOnRandomRobots) {
  int joints = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const std::string text = test::random_urdf(seed);
    const model::KinematicTree tree = test::tree_of(text, {.floating_base = seed % 2 == 0});
    joints += tree.dof();
    expect_agreement(text, tree);
  }
  EXPECT_GT(joints, 300);
}

// Snapped angles are the intended multiples of PI/12.
TEST(Oracle, AgreesOnSnappedAngles) {
  for (std::uint64_t seed = 1; seed <= kSeeds && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const std::string meant = test::random_urdf(seed, {.exact_angles = true});
    const std::string written = test::random_urdf(seed, {.exact_angles = true, .angle_error = 5e-7});
    expect_agreement(meant, test::tree_of(written, {.snap_angles = true}));
    expect_agreement(written, test::tree_of(written));
  }
}

// Snapping has an effect as large as the sum of the angle changes, of which there are dozens along a chain.
TEST(Oracle, SnappingChangesNoMoreThanItSays) {
  constexpr double kSumOfSnaps = 60 * 1e-6;
  for (std::uint64_t seed = 1; seed <= 50 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const std::string text = test::random_urdf(seed);
    expect_agreement(text, test::tree_of(text, {.snap_angles = true}), kSumOfSnaps);
  }
}

class Models : public testing::TestWithParam<bool> {};

TEST_P(Models, AgreeWithTheOracle) {
  const auto files = test::files(ROBCOGEN_MODELS_DIR, {".urdf"});
  if (files.empty()) GTEST_SKIP() << "no URDFs in " << ROBCOGEN_MODELS_DIR;
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename());
    const std::string text = test::contents(file);
    import::UrdfOptions options{.floating_base = GetParam(), .free_mimic_joints = true};
    const auto as_is = test::imported(text, options);
    ASSERT_TRUE(as_is.tree) << as_is.diagnostics.render();
    expect_agreement(text, *as_is.tree);
    options.snap_angles = true;
    constexpr double kSumOfSnaps = 1e-4;  // dozens of them along a chain
    expect_agreement(text, test::tree_of(text, options), kSumOfSnaps);
  }
}

INSTANTIATE_TEST_SUITE_P(Base, Models, testing::Bool(), [](const auto& base) {
  return base.param ? "Floating" : "Fixed";
});

}  // namespace
}  // namespace robcogen::oracle_test
