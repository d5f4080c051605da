// Documents with joints of all types, drives, limits and couplings are written again: the model and the numbers stay
// the same.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "dice.h"
#include "export/kinematics.h"
#include "import/urdf.h"
#include "interpreted_robot.h"
#include "robots.h"
#include "same_physics.h"
#include "same_tree.h"
#include "support/index.h"

namespace robcogen::joints_test {
namespace {

using model::KinematicTree;
using model::Quantity;
using numeric::Dice;

// ---- Random documents.

struct Options {
  bool parameters = true;
  bool only_urdf = false;  // only joints and couplings that URDF has
};

class RandomDocument {
 public:
  RandomDocument(std::uint64_t seed, const Options& options) : dice_(seed + 0x3c6ef372fe94f82b), options_(options) {
    const int links = 2 + dice_.below(6);
    for (int i = 0; i < links; ++i) add_joint(i);
    text_ = fmt::format(
        "Robot Any {{\nRobotBase trunk {}{{ {} {} }}\n", dice_.chance(0.3) ? "floating " : "", inertia(), children(-1));
    for (int i = 0; i < links; ++i) {
      const std::string frames = dice_.chance(0.4) ? fmt::format("frames {{ tip{} {{ {} }} }}", i, placement()) : "";
      text_ += fmt::format("link l{} {{ id = {} {} {} {} }}\n", i, i + 1, inertia(), children(i), frames);
    }
    text_ += joints_ + couplings() + "}\n";
  }

  const std::string& text() const { return text_; }

 private:
  struct Coordinate {
    std::string name;
    bool turns;
    bool follows = false;
  };

  Dice dice_;
  Options options_;
  std::string text_, joints_;
  std::vector<std::string> parameters_;  // of drives and mass properties
  std::vector<int> parents_;             // by link; -1: the base
  std::vector<std::string> joint_of_;    // by link
  std::vector<Coordinate> coordinates_;

  double number(double low, double high) { return std::round(dice_.between(low, high) * 1e4) / 1e4; }

  // Returns a number, or sometimes an expression with a parameter that has a default.
  std::string value(double low, double high) {
    const double n = number(low, high);
    if (!options_.parameters || !dice_.chance(0.2)) return spelled(n);
    parameters_.push_back(fmt::format("p{}", parameters_.size()));
    return fmt::format("{} * {}[{}]", spelled(2.0), parameters_.back(), spelled(n / 2));
  }

  static std::string spelled(double n) {
    std::string text = fmt::format("{}", n);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
  }

  std::string angle() {
    constexpr std::array kTurns = {"0.0", "PI", "-PI/2.0", "PI/2.0", "PI/3.0"};
    return dice_.chance(0.6) ? kTurns[at(dice_.below(5))] : value(-3, 3);
  }

  // `plain`: without parameters, for universal and planar joints.
  std::string placement(bool plain = false) {
    const auto offset = [&] {
      return dice_.chance(0.4) ? std::string("0.0") : plain ? spelled(number(-1, 1)) : value(-1, 1);
    };
    const auto turn = [&] { return plain ? spelled(number(-3, 3)) : angle(); };
    return fmt::format(
        "translation = ({}, {}, {}) rotation = ({}, {}, {})", offset(), offset(), offset(), turn(), turn(), turn());
  }

  std::string inertia() {
    return fmt::format(
        "inertia_params {{ mass = {} CoM = ({}, {}, {}) Ix = {} Iy = {} Iz = {} Ixy = {} Ixz = 0.0 Iyz = {} }}",
        value(1, 3), spelled(number(-0.1, 0.1)), spelled(number(-0.1, 0.1)), spelled(number(-0.1, 0.1)),
        value(0.8, 1.2), value(0.8, 1.2), value(0.8, 1.2), spelled(number(-0.05, 0.05)), spelled(number(-0.05, 0.05)));
  }

  std::string children(int link) {
    std::string text = "children {";
    for (std::size_t i = 0; i < parents_.size(); ++i)
      if (parents_[i] == link) text += fmt::format(" l{} via {}", i, joint_of_[i]);
    return text + " }";
  }

  std::string carrier(int parent) { return parent < 0 ? "trunk" : fmt::format("l{}", parent); }

  std::string drive(int link, bool is_compound) {
    std::string text;
    if (dice_.chance(0.4)) text += fmt::format(" damping = {}", value(0.1, 2));
    if (dice_.chance(0.3))
      text += dice_.chance(0.5)
                  ? fmt::format(" friction = {}", value(0.1, 2))
                  : fmt::format(" friction {{ force = {} velocity = {} }}", value(0.1, 2), value(0.01, 0.1));
    if (dice_.chance(0.3)) text += fmt::format(" armature = {}", value(0.1, 2));
    if (dice_.chance(0.3))
      text += dice_.chance(0.5) ? fmt::format(" spring {{ stiffness = {} }}", value(1, 20))
                                : fmt::format(" spring {{ stiffness = {} rest = {} }}", value(1, 20), value(-1, 1));
    if (dice_.chance(0.3)) text += rotor(link, is_compound);
    return text + limits();
  }

  std::string rotor(int link, bool is_compound) {
    std::string text = fmt::format(" rotor {{ inertia = {} ratio = {}", value(0.001, 0.01), value(1, 10));
    const bool is_elsewhere = is_compound || dice_.chance(0.5);
    if (is_elsewhere)
      text += fmt::format(
          " axis = ({}, {}, 1.0) carrier = {}", value(-1, 1), value(-1, 1), carrier(dice_.below(link + 1) - 1));
    return text + " }";
  }

  std::string limits() {
    if (dice_.chance(0.5)) return "";
    std::string text = " limits {";
    if (dice_.chance(0.6)) text += fmt::format(" position = ({}, {})", spelled(number(-2, 0)), spelled(number(0, 2)));
    if (dice_.chance(0.6)) text += fmt::format(" velocity = {}", spelled(number(1, 9)));
    if (dice_.chance(0.6)) text += fmt::format(" effort = {}", spelled(number(1, 90)));
    return text + " }";
  }

  void add_joint(int link) {
    struct Type {
      const char* word;
      std::vector<std::pair<const char*, bool>> coordinates;  // name, and whether it is an angle
    };
    static const std::vector<Type> kTypes = {
        {"r_joint", {}},
        {"p_joint", {}},
        {"c_joint", {{"slide", false}, {"turn", true}}},
        {"u_joint", {{"turn_x", true}, {"turn_z", true}}},
        {"planar_joint", {{"slide_x", false}, {"slide_y", false}, {"turn", true}}},
        {"h_joint", {}},
        {"s_joint", {}}};
    const auto k = at(dice_.below(options_.only_urdf ? 5 : 7));
    const std::string word = kTypes[k].word, name = fmt::format("j{}", link);
    parents_.push_back(dice_.below(link + 1) - 1);
    joint_of_.push_back(name);
    std::string body = fmt::format("ref_frame {{ {} }}", placement(!kTypes[k].coordinates.empty()));
    if (word == "h_joint") body += fmt::format(" pitch = {}", value(0.01, 0.1));
    if (word == "s_joint") {
      if (dice_.chance(0.5)) body += fmt::format(" damping = {}", value(0.1, 2));
      if (dice_.chance(0.5)) body += fmt::format(" armature = {}", value(0.1, 2));
      if (dice_.chance(0.5)) body += fmt::format(" limits {{ velocity = {} }}", spelled(number(1, 9)));
    } else if (kTypes[k].coordinates.empty()) {
      body += drive(link, false);
      coordinates_.push_back({name, word != "p_joint"});
    }
    for (const auto& [coordinate, turns] : kTypes[k].coordinates) {
      coordinates_.push_back({name + "_" + coordinate, turns});
      if (dice_.chance(0.6)) body += fmt::format(" {} {{{} }}", coordinate, drive(link, true));
    }
    joints_ += fmt::format("{} {} {{ {} }}\n", word, name, body);
  }

  std::string couplings() {
    if (coordinates_.size() < 2) return "";
    std::string text = "couplings {\n";
    const auto leader = at(dice_.below(static_cast<int>(coordinates_.size())));
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      if (i == leader || !dice_.chance(0.3)) continue;
      text += fmt::format("  {} = {}", coordinates_[i].name, term(coordinates_[i], coordinates_[leader]));
      if (!options_.only_urdf && dice_.chance(0.4)) text += other_term(i, leader);
      if (dice_.chance(0.5)) text += " + " + value(-1, 1);
      text += "\n";
      coordinates_[i].follows = true;
    }
    return text + "}\n";
  }

  std::string term(const Coordinate& of, const Coordinate& by) {
    const char* unit = of.turns == by.turns ? "" : of.turns ? " rad/m" : " m/rad";
    return fmt::format("{}{} * {}", dice_.chance(0.3) ? "-1.0" : spelled(number(0.1, 2)), unit, by.name);
  }

  // Returns a term in an earlier coordinate that follows no other.
  std::string other_term(std::size_t of, std::size_t leader) {
    for (std::size_t i = 0; i < of; ++i)
      if (i != leader && !coordinates_[i].follows) return " + " + term(coordinates_[of], coordinates_[i]);
    return "";
  }
};

KinematicTree read(const std::string& text) {
  Diagnostics diagnostics;
  const auto tree = test::read_document(std::make_shared<Source>("random.kindsl", text), diagnostics);
  if (!tree) throw std::runtime_error(diagnostics.render() + text);
  return *tree;
}

KinematicTree written_and_read(const KinematicTree& tree) {
  return read(
      language::kinematics::print(exporting::numbered_parents_first(tree, exporting::kinematics_document(tree))));
}

// Compares computed results. The angles of universal and planar joints are sums, which may be rounded differently.
void expect_same_numbers(const KinematicTree& found, const KinematicTree& expected, std::uint64_t seed) {
  constexpr double kRounding = 1e-12;
  std::vector<double> parameters;
  for (const model::Parameter& p : expected.parameters) parameters.push_back(p.default_value.value());
  const std::vector<std::string> groups = {"inverse_dynamics", "joint_space_inertia", "passive_forces"};
  const numeric::InterpretedRobot first(found, {}, {}, parameters, {}, groups);
  const numeric::InterpretedRobot second(expected, {}, {}, parameters, {}, groups);
  std::mt19937_64 engine(seed);
  const reference::Motion<double> m = reference::random_sample(engine, second.tables()).motion;
  const auto expect_near = [](const reference::Matrix<double>& a, const reference::Matrix<double>& b) {
    EXPECT_LE(reference::largest(a - b), kRounding * (1 + reference::largest(b)));
  };
  expect_near(first.inverse_dynamics_fully_actuated(m, {}), second.inverse_dynamics_fully_actuated(m, {}));
  expect_near(first.joint_space_inertia(m.q), second.joint_space_inertia(m.q));
  expect_near(first.passive_forces(m), second.passive_forces(m));
}

constexpr std::uint64_t kDocuments = 200;

TEST(JointsInDocuments, AreTheSameWrittenAgain) {
  int spherical = 0, coupled = 0, rotors = 0;
  for (std::uint64_t seed = 0; seed < kDocuments; ++seed) {
    const RandomDocument document(seed, {});
    SCOPED_TRACE(document.text());
    const KinematicTree tree = read(document.text()), again = written_and_read(tree);
    test::SameTree(again, tree).expect();
    expect_same_numbers(again, tree, seed);
    if (HasFailure()) return;
    spherical += tree.spherical_joints().empty() ? 0 : 1;
    coupled += tree.couplings.empty() ? 0 : 1;
    rotors += tree.has_rotors() ? 1 : 0;
  }
  EXPECT_GT(spherical, 50);
  EXPECT_GT(coupled, 100);
  EXPECT_GT(rotors, 100);
}

// Keeps what URDF has: joints that turn or slide (several coordinates become chains), damping, friction, position and
// other limits, and couplings to one joint.
KinematicTree without_what_urdf_lacks(KinematicTree tree) {
  for (model::Joint& joint : tree.joints) {
    joint.drive.armature = joint.drive.stiffness = joint.drive.rest = joint.drive.friction_velocity = Quantity();
    joint.drive.rotor.reset();
  }
  return tree;
}

TEST(JointsInDocuments, SurviveAUrdf) {
  for (std::uint64_t seed = 0; seed < kDocuments / 4; ++seed) {
    const RandomDocument document(seed, {.parameters = false, .only_urdf = true});
    SCOPED_TRACE(document.text());
    const KinematicTree tree = without_what_urdf_lacks(read(document.text()));
    Diagnostics diagnostics;
    import::UrdfOptions options;
    options.passive_forces = true;
    const auto back =
        import::urdf(std::make_shared<Source>("exported.urdf", exporting::urdf(tree)), options, diagnostics);
    ASSERT_TRUE(back.has_value()) << diagnostics.render();
    EXPECT_EQ(back->joints.size(), tree.joints.size());
    ASSERT_EQ(back->couplings.size(), tree.couplings.size());
    for (const model::Joint& joint : tree.joints) {
      const auto found = back->find_joint(joint.name);
      ASSERT_TRUE(found.has_value()) << joint.name;
      const model::Joint& other = back->joints[at(*found)];
      EXPECT_EQ(other.type, joint.type);
      EXPECT_EQ(evaluate(other.drive.damping), evaluate(joint.drive.damping));
      EXPECT_EQ(evaluate(other.drive.friction), evaluate(joint.drive.friction));
    }
    constexpr double kTolerance = 1e-12;
    const test::Differences worst = test::differences(*back, tree, seed, 2);
    EXPECT_LT(worst.inertia_matrix, kTolerance);
    EXPECT_LT(worst.inverse_dynamics, kTolerance);
    EXPECT_LT(worst.forward_dynamics, kTolerance);
    EXPECT_LT(worst.poses, kTolerance);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace robcogen::joints_test
