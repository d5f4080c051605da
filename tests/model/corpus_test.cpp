// Robot descriptions of other projects: each builds, or is refused for its known reason.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "patterns.h"
#include "reading.h"

namespace robcogen::corpus_test {
namespace {

using model::KinematicTree;
using std::filesystem::path;

std::vector<path> documents(const std::string& extension) {
  std::vector<path> result;
  if (!std::filesystem::is_directory(ROBCOGEN_CORPUS_DIR)) return result;
  for (const auto& entry : std::filesystem::directory_iterator(ROBCOGEN_CORPUS_DIR)) {
    if (entry.path().extension() == extension) result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Documents that are malformed or in another dialect, with the code of their message.
const std::map<std::string, std::string> kRefused = {
    {"ESROCOS_kin-gen__tests_models_malformed_cmm-disconnected", "island"},
    {"ESROCOS_kin-gen__tests_models_malformed_cmm-typo", ""},      // a syntax error: the code is the parser's
    {"mfrigerio17_dsl-kinematics__models_two_links", ""},          // dialect of 2012, likewise
    {"ESROCOS_kin-gen__tests_coverage_sample_fk1_model_ur5", ""},  // a list of queries
    {"idra-lab_quadruped_robcogen__config_robot", ""},             // a list with placeholders
};

bool is_refused(const path& document) {
  return kRefused.contains(document.stem().string());
}

class Corpus : public testing::Test {
 protected:
  void SetUp() override {
    if (documents(".kindsl").empty()) GTEST_SKIP() << "no documents in " << ROBCOGEN_CORPUS_DIR;
  }
};

// The well-formed robots, by the stem of their documents.
std::map<std::string, KinematicTree> robots() {
  std::map<std::string, KinematicTree> result;
  for (const path& document : documents(".kindsl")) {
    if (is_refused(document)) continue;
    Diagnostics diagnostics;
    if (const auto tree = test::tree_of(test::source_of_file(document), diagnostics))
      result[document.stem().string()] = *tree;
  }
  return result;
}

TEST_F(Corpus, BuildsUnlessMalformed) {
  for (const path& document : documents(".kindsl")) {
    Diagnostics diagnostics;
    const auto tree = test::tree_of(test::source_of_file(document), diagnostics);
    EXPECT_EQ(tree.has_value(), !is_refused(document)) << document << "\n" << diagnostics.render();
    EXPECT_EQ(tree.has_value(), !diagnostics.has_errors()) << document;
  }
}

TEST_F(Corpus, RefusesWhatIsMalformedForItsReason) {
  for (const auto& [name, code] : kRefused) {
    const path robot = path(ROBCOGEN_CORPUS_DIR) / (name + ".kindsl"), list = path(robot).replace_extension(".dtdsl");
    Diagnostics diagnostics;
    if (exists(robot)) {
      test::tree_of(test::source_of_file(robot), diagnostics);
    } else {
      language::desired::parse(test::source_of_file(list), diagnostics);
    }
    ASSERT_TRUE(diagnostics.has_errors()) << name;
    const auto& all = diagnostics.all();
    const bool named =
        std::any_of(all.begin(), all.end(), [wanted = code](const Diagnostic& d) { return d.code == wanted; });
    EXPECT_TRUE(named || code.empty()) << diagnostics.render();
  }
}

// The elements are counted in the text, without a parser.
TEST_F(Corpus, HasAsManyElementsAsTheTextDeclares) {
  const auto count = [](const std::string& text, const std::string& pattern) {
    return static_cast<long>(test::all_matches(text, pattern).size());
  };
  for (const auto& [name, tree] : robots()) {
    SCOPED_TRACE(name);
    std::string text = test::contents(path(ROBCOGEN_CORPUS_DIR) / (name + ".kindsl"));
    text = test::replaced(text, R"re(/\*([^*]|\*[^/])*\*/|//[^\n]*)re", " ");
    EXPECT_EQ(static_cast<long>(tree.joints.size()), count(text, R"re(\b[rp]_joint\s)re"));
    EXPECT_EQ(static_cast<long>(tree.links.size()) - 1, count(text, R"re(\blink\s+\w+\s*\{)re"));
    EXPECT_EQ(tree.floating_base, count(text, R"re(\bfloating\b)re") == 1);
  }
}

TEST_F(Corpus, HasTheKnownRobots) {
  struct Facts {
    const char* document;
    int dof;
    std::size_t links;
    bool floating;
    std::size_t parameters;
  };
  const auto all = robots();
  for (const Facts& facts : {
           Facts{"mfrigerio17_dsl-kinematics__models_HyQ", 12, 13, true, 0},
           Facts{"mfrigerio17_dsl-kinematics__models_FixedHyQ", 12, 13, false, 0},
           Facts{"mfrigerio17_dsl-kinematics__models_fancy", 5, 6, false, 0},
           Facts{"mfrigerio17_robcogen2__sample_fancy_fancy", 5, 6, false, 2},
           Facts{"DrawZeroPoint_control-toolbox__ct_models_include_ct_models_Talos_model_Talos", 12, 13, true, 0},
           Facts{
               "DrawZeroPoint_control-toolbox__ct_rbd_test_models_testIrb4600_description_testirb4600", 6, 7, false, 0},
       }) {
    SCOPED_TRACE(facts.document);
    ASSERT_TRUE(all.contains(facts.document));
    const KinematicTree& tree = all.at(facts.document);
    EXPECT_EQ(tree.dof(), facts.dof);
    EXPECT_EQ(tree.links.size(), facts.links);
    EXPECT_EQ(tree.floating_base, facts.floating);
    EXPECT_EQ(tree.parameters.size(), facts.parameters);
  }
}

// The id of a link in this document is too large. This leaves a gap, and the link's child has a smaller id. Both get a
// warning, nothing more.
TEST_F(Corpus, WarnsOfAWrongId) {
  Diagnostics diagnostics;
  const path document = path(ROBCOGEN_CORPUS_DIR) / "ESROCOS_kin-gen__tests_models_malformed_cmm-numbering.kindsl";
  EXPECT_TRUE(test::tree_of(test::source_of_file(document), diagnostics).has_value());
  ASSERT_EQ(diagnostics.all().size(), 2u) << diagnostics.render();
  EXPECT_EQ(diagnostics.all()[1].code, "gapped-ids");
  EXPECT_EQ(diagnostics.all()[0].code, "child-before-parent");
}

TEST_F(Corpus, MovesMassPropertiesAsTheTextbookDoes) {
  constexpr double kTolerance = 1e-13;  // about ten roundings, relative to the largest element
  int moved = 0;
  for (const auto& [name, tree] : robots()) {
    std::vector<double> parameters;
    for (const auto& parameter : tree.parameters) parameters.push_back(parameter.default_value.value_or(0.7));
    const auto value = [&](const model::Quantity& q) { return evaluate(q, parameters); };
    const auto vector = [&](const std::array<model::Quantity, 3>& v) {
      return Eigen::Vector3d(value(v[0]), value(v[1]), value(v[2]));
    };
    const auto tensor = [&](const auto& i) {
      Eigen::Matrix3d I;
      I << value(i.ixx), -value(i.ixy), -value(i.ixz), -value(i.ixy), value(i.iyy), -value(i.iyz), -value(i.ixz),
          -value(i.iyz), value(i.izz);
      return I;
    };
    const auto shift = [](double m, const Eigen::Vector3d& c) -> Eigen::Matrix3d {
      return m * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    };
    for (const model::Link& link : tree.links) {
      if (!link.inertia) continue;
      SCOPED_TRACE(name + " " + link.name);
      Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
      if (link.inertia->reference) {
        const Eigen::Vector3d r = vector(link.inertia->reference->rotation);
        frame = Eigen::Translation3d(vector(link.inertia->reference->translation)) *
                Eigen::AngleAxisd(r[0], Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(r[1], Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(r[2], Eigen::Vector3d::UnitZ());
        ++moved;
      }
      const double m = value(link.inertia->mass);
      const Eigen::Vector3d c = vector(link.inertia->com), c_link = frame * c;
      const Eigen::Matrix3d central = tensor(*link.inertia) - shift(m, c);
      const Eigen::Matrix3d expected = frame.rotation() * central * frame.rotation().transpose() + shift(m, c_link);
      const model::RigidBodyInertia body = model::in_link_frame(*link.inertia);
      EXPECT_EQ(value(body.mass), m);
      EXPECT_TRUE(vector(body.first_moment).isApprox(m * c_link, kTolerance) || c_link.isZero(kTolerance));
      EXPECT_TRUE(tensor(body).isApprox(expected, kTolerance) || expected.isZero(kTolerance));
    }
  }
  EXPECT_GT(moved, 10) << "hardly any document uses ref_frame: the check is empty";
}

// Every list is read for every robot with its name; a pair is resolved if the robot has both frames.
TEST_F(Corpus, ResolvesItsDesiredTransforms) {
  int resolved = 0;
  const auto resolve = [&](const path& list, const KinematicTree& tree) {
    SCOPED_TRACE(list.filename().string());
    Diagnostics diagnostics;
    const auto document = language::desired::parse(test::source_of_file(list), diagnostics);
    ASSERT_FALSE(diagnostics.has_errors()) << diagnostics.render();
    if (document.robot.text != tree.name) return;
    const auto desired = import::desired_transforms(document, tree, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
    const auto known = [&](const std::vector<language::desired::Pair>& pairs) {
      std::set<std::pair<std::string, std::string>> result;
      for (const auto& pair : pairs)
        if (tree.find_frame(pair.left.text) && tree.find_frame(pair.right.text))
          result.insert({pair.left.text, pair.right.text});
      return result.size();
    };
    EXPECT_EQ(desired.transforms.size(), known(document.transforms));
    EXPECT_EQ(desired.jacobians.size(), known(document.jacobians));
    if (!desired.transforms.empty()) ++resolved;
  };
  for (const auto& [name, tree] : robots()) {
    for (const path& list : documents(".dtdsl")) {
      if (!is_refused(list)) resolve(list, tree);
    }
  }
  EXPECT_GT(resolved, 8);
}

}  // namespace
}  // namespace robcogen::corpus_test
