// Round trips from a robot document to URDF and back, and from URDF to a robot document and back, keep the robot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "export/kinematics.h"
#include "export/urdf.h"
#include "import/urdf.h"
#include "model/plausibility.h"
#include "random_robot.h"
#include "robcogen/reference/samples.h"
#include "robots.h"
#include "same_physics.h"
#include "urdf_reader.h"

namespace robcogen::round_trip_test {
namespace {

using model::JointLimits;
using model::KinematicTree;
using std::filesystem::path;
using test::Differences;

constexpr std::uint64_t kSeed = 5;
constexpr int kStates = 5;
// Tolerance of a round trip. Numbers are rounded a few times, by about 1e-15 each; if the inertia matrix is badly
// conditioned, the error of accelerations is a hundred times larger.
constexpr double kTolerance = 1e-12;

struct Read {
  std::optional<KinematicTree> tree;
  Diagnostics diagnostics;
};

bool reports(const Read& read, const std::string& code) {
  const auto& all = read.diagnostics.all();
  return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) { return d.code == code; });
}

Read read_urdf(std::shared_ptr<const Source> source, bool floating_base = false, bool allow_implausible = false) {
  import::UrdfOptions options;
  options.floating_base = floating_base;
  options.allow_implausible = allow_implausible;
  options.passive_forces = true;  // as in robot documents
  Read result;
  result.tree = import::urdf(std::move(source), options, result.diagnostics);
  return result;
}

Read through_urdf(const KinematicTree& tree, bool allow_implausible = false) {
  return read_urdf(std::make_shared<Source>("exported.urdf", exporting::urdf(tree)), false, allow_implausible);
}

Read through_document(const KinematicTree& tree) {
  const std::string text = language::kinematics::print(exporting::kinematics_document(tree));
  Read result;
  result.tree = test::read_document(std::make_shared<Source>("exported.kindsl", text), result.diagnostics);
  return result;
}

KinematicTree with_base(KinematicTree tree, bool floating) {
  tree.floating_base = floating;
  tree.inertia_defects = model::inertia_defects(tree);
  return tree;
}

// ---- Properties that a round trip preserves.

void expect_same_robot(const KinematicTree& found, const KinematicTree& expected) {
  EXPECT_EQ(found.name, expected.name);
  EXPECT_EQ(found.floating_base, expected.floating_base);
  ASSERT_EQ(found.links.size(), expected.links.size());
  for (std::size_t i = 0; i < expected.links.size(); ++i) EXPECT_EQ(found.links[i].name, expected.links[i].name);
  ASSERT_EQ(found.joints.size(), expected.joints.size());
  for (std::size_t j = 0; j < expected.joints.size(); ++j) {
    EXPECT_EQ(found.joints[j].name, expected.joints[j].name);
    EXPECT_EQ(found.joints[j].type, expected.joints[j].type);
    EXPECT_EQ(found.joints[j].parent, expected.joints[j].parent);
    EXPECT_EQ(found.joints[j].child, expected.joints[j].child);
  }
  const std::vector<std::string> names = test::named_frames(found);
  for (const std::string& name : test::named_frames(expected))
    ASSERT_TRUE(std::find(names.begin(), names.end(), name) != names.end()) << "no frame is called " << name;

  const Differences worst = test::differences(found, expected, kSeed, kStates);
  EXPECT_EQ(found.inertia_defects.is_singular(), expected.inertia_defects.is_singular());
  EXPECT_LT(worst.inertia_matrix, kTolerance);
  EXPECT_LT(worst.inverse_dynamics, kTolerance);
  EXPECT_LT(worst.forward_dynamics, kTolerance);
  EXPECT_LT(worst.poses, kTolerance);
}

// Converts to URDF, back to the model, to a document, and back again.
void expect_survives_urdf(const KinematicTree& tree, bool allow_implausible = false) {
  const Read back = through_urdf(tree, allow_implausible);
  ASSERT_TRUE(back.tree.has_value()) << back.diagnostics.render();
  const Read document = through_document(*back.tree);
  ASSERT_TRUE(document.tree.has_value()) << document.diagnostics.render();
  expect_same_robot(*document.tree, tree);
}

// A robot with a singular inertia matrix survives like any other, and the readers report the functions that it lacks.
void expect_singular(const KinematicTree& tree, bool allow_implausible = false) {
  EXPECT_TRUE(reports(through_document(tree), "singular-inertia"));
  EXPECT_TRUE(reports(through_urdf(tree, allow_implausible), "singular-inertia"));
}

// ---- From documents.

// The mass properties of these robots belong to no possible body: their moments were probably meant about the centre of
// mass. A robot document gets a warning; a URDF is refused unless the option allows it.
const std::set<std::string> kNoBody = {
    "DrawZeroPoint_control-toolbox__ct_models_include_ct_models_QuadrotorWithLoad_model_ct_quadrotor.kindsl",
    "DrawZeroPoint_control-toolbox__ct_rbd_test_models_testIrb4600_description_testirb4600.kindsl",
    "mfrigerio17_dsl-kinematics__models_FixedHyQ.kindsl",
    "mfrigerio17_dsl-kinematics__models_HyQ.kindsl",
};

// The base has no inertia, or inertia about fewer than three axes, and only free joints hold it: if it floats, H is
// singular in every position.
const std::set<std::string> kCannotFloat = {
    "hyl.kindsl",
    "iiwa14.kindsl",
    "puma560.kindsl",
    "tree5.kindsl",
    "ChenkaiMao97_RobcogenCppAd__pybind_robots_Acrobot.kindsl",
    "DrawZeroPoint_control-toolbox__ct_models_include_ct_models_DoubleInvertedPendulum_model_"
    "ct_DoubleInvertedPendulum.kindsl",
    "DrawZeroPoint_control-toolbox__ct_models_include_ct_models_HyA_model_ct_HyA.kindsl",
    "DrawZeroPoint_control-toolbox__ct_rbd_test_models_testIrb4600_description_testirb4600.kindsl",
    "macstepien_furuta_pendulum__furuta_pendulum_control_toolbox_model_FurutaPendulum.kindsl",
    "mfrigerio17_dsl-kinematics__models_fancy.kindsl",
    "mfrigerio17_dsl-kinematics__models_fancybranch.kindsl",
};

TEST(RoundTrip, FromDocumentToUrdfAndBack) {
  for (const test::NamedRobot& robot : test::constant_robots()) {
    for (const bool floating : {false, true}) {
      SCOPED_TRACE(robot.document + (floating ? ", floating" : ", fixed"));
      const KinematicTree tree = with_base(robot.tree, floating);
      const bool is_no_body = kNoBody.contains(robot.document);
      if (is_no_body) {
        EXPECT_TRUE(reports(through_urdf(tree), "inertia-not-positive"));
      }
      if (floating && kCannotFloat.contains(robot.document)) expect_singular(tree, is_no_body);
      expect_survives_urdf(tree, is_no_body);
    }
  }
}

TEST(RoundTrip, OfRandomRobots) {
  constexpr std::uint64_t kRobots = 100;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const KinematicTree tree = numeric::random_robot(seed, {.screws = false});
    SCOPED_TRACE(numeric::describe(tree));
    expect_survives_urdf(tree);
    if (HasFailure()) return;
  }
}

// ---- From URDFs.

const std::set<std::string> kUrdfsThatCannotFloat = {"iiwa14.urdf"};  // its root has no inertia

class Models : public testing::Test {
 protected:
  void SetUp() override {
    if (files_.empty()) GTEST_SKIP() << "no URDFs in " << ROBCOGEN_MODELS_DIR;
  }

  std::vector<path> files_ = test::files_below(ROBCOGEN_MODELS_DIR, ".urdf");
};

TEST_F(Models, SurviveAsDocuments) {
  for (const path& file : files_) {
    for (const bool floating : {false, true}) {
      SCOPED_TRACE(file.filename().string() + (floating ? ", floating" : ", fixed"));
      const Read original = read_urdf(test::source_of(file), floating);
      EXPECT_EQ(
          reports(original, "singular-inertia"), floating && kUrdfsThatCannotFloat.contains(file.filename().string()));
      ASSERT_TRUE(original.tree.has_value()) << original.diagnostics.render();
      const Read document = through_document(*original.tree);
      ASSERT_TRUE(document.tree.has_value()) << document.diagnostics.render();
      expect_same_robot(*document.tree, *original.tree);
      expect_survives_urdf(*document.tree);
    }
  }
}

// URDF requires bounds even if the model has none; those are wide.
void expect_same_limits(const JointLimits& found, const JointLimits& expected) {
  constexpr double kWide = 1e9;
  const auto expect_bound = [&](double bound, double original) {
    if (std::isfinite(original)) {
      EXPECT_EQ(bound, original);
    } else {
      EXPECT_EQ(std::signbit(bound), std::signbit(original));
      EXPECT_GE(std::abs(bound), kWide);
    }
  };
  expect_bound(found.lower, expected.lower);
  expect_bound(found.upper, expected.upper);
  expect_bound(found.velocity, expected.velocity);
  expect_bound(found.effort, expected.effort);
}

TEST_F(Models, KeepTheirLimits) {
  int limited = 0;
  for (const path& file : files_) {
    const Read original = read_urdf(test::source_of(file));
    ASSERT_TRUE(original.tree.has_value()) << original.diagnostics.render();
    const Read document = through_document(*original.tree);
    ASSERT_TRUE(document.tree.has_value()) << document.diagnostics.render();
    const Read back = through_urdf(*document.tree);
    ASSERT_TRUE(back.tree.has_value()) << back.diagnostics.render();
    for (std::size_t j = 0; j < original.tree->joints.size(); ++j) {
      SCOPED_TRACE(file.filename().string() + ": " + original.tree->joints[j].name);
      const JointLimits& limits = original.tree->joints[j].limits;
      expect_same_limits(back.tree->joints[j].limits, limits);
      if (limits != JointLimits()) ++limited;
    }
  }
  EXPECT_GT(limited, 50) << "hardly any joint has limits: the check is empty";
}

// Converts `joint_8.0` to `joint_8_0`.
std::string as_identifier(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

// urdfdom refuses revolute joints without limits.
const std::set<std::string> kNotForUrdfdom = {"iiwa14.urdf"};

// Compares the original and the result with an independent reader.
TEST_F(Models, AreTheSameForAnIndependentReader) {
  for (const path& file : files_) {
    SCOPED_TRACE(file.filename().string());
    const auto source = test::source_of(file);
    const Read imported = read_urdf(source);
    ASSERT_TRUE(imported.tree.has_value()) << imported.diagnostics.render();
    const std::string text(source->text());
    if (kNotForUrdfdom.contains(file.filename().string())) {
      EXPECT_ANY_THROW(test::UrdfReader{text});
      continue;
    }
    const test::UrdfReader original(text), exported(exporting::urdf(*imported.tree));
    EXPECT_EQ(exported.complaints(), "");
    EXPECT_EQ(exported.base().name, as_identifier(original.base().name));

    std::vector<std::string> joints, exported_joints;
    test::UrdfReader::Positions q, exported_q;
    std::mt19937_64 engine(kSeed);
    for (const auto& [name, joint] : original.model().joints_) {
      if (joint->type == urdf::Joint::FIXED) continue;
      joints.push_back(name);
      exported_joints.push_back(as_identifier(name));
      q[name] = exported_q[as_identifier(name)] = reference::uniform(engine, 3);
    }
    ASSERT_EQ(joints.size(), imported.tree->joints.size());
    const auto poses = exported.poses(exported_q);
    for (const auto& [link, pose] : original.poses(q)) {
      const std::string name = as_identifier(link);
      ASSERT_TRUE(poses.contains(name)) << name;
      EXPECT_LT((poses.at(name).matrix() - pose.matrix()).cwiseAbs().maxCoeff(), kTolerance) << name;
    }
    const Eigen::MatrixXd H = original.inertia_matrix(joints, q);
    const Eigen::MatrixXd found = exported.inertia_matrix(exported_joints, exported_q);
    EXPECT_LT((found - H).cwiseAbs().maxCoeff() / H.cwiseAbs().maxCoeff(), kTolerance);
  }
}

}  // namespace
}  // namespace robcogen::round_trip_test
