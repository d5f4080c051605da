// One mechanism, cut at each of its pivots in turn and led by each choice of its joints: however it is written, its
// links move alike.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "dice.h"
#include "import/kinematics.h"
#include "interpreted_robot.h"
#include "language/kinematics/document.h"
#include "volume.h"

namespace robcogen::numeric {
namespace {

using reference::Real;
using reference::Vector;

constexpr double kSame = 1e-10;

// A closed chain of links in a plane: pivot k joins links k and k + 1, the last pivot the last link and link 0, which
// is the base. Link 2 carries an arm on a skew joint, `extra`. At q = 0 the axes of all links are those of the base.
class Ring {
 public:
  Ring(int size, std::uint64_t seed) : size_(size), dice_(seed) {
    constexpr double kPi = 3.14159265358979323846;
    for (int k = 0; k < size; ++k) {
      const double angle = 2 * kPi * k / size;
      pivots_.push_back({0.3 * std::cos(angle) + noise(), 0.3 * std::sin(angle) + noise()});
      heights_.push_back(k == 0 ? 0.0 : noise());
      bodies_.push_back(body());
    }
    arm_ = {pivots_[1].x + noise(), pivots_[1].y + noise()};
    turn_of_arm_ =
        fmt::format("rotation = ({}, {}, {})", dice_.between(-1, 1), dice_.between(-1, 1), dice_.between(-1, 1));
  }

  int size() const { return size_; }
  static std::string name(int pivot) { return fmt::format("p{}", pivot); }

  // The tree that is left without this pivot; a loop closes it.
  std::string document(int cut, const std::vector<int>& leaders, const std::string& type) const {
    std::string text = "Robot Ring { RobotBase link0 { " + children(0, cut) + frames(0, cut) + "} ";
    for (int link = 1; link < size_; ++link)
      text += fmt::format(
          "link link{} {{ id = {} inertia_params {{ {} ref_frame = body{} }} {} {} }} ", link, link, bodies_[at(link)],
          link, children(link, cut), frames(link, cut));
    text += "link arm { id = 9 inertia_params { " + bodies_.front() + " } children {} } ";
    for (int pivot = 0; pivot < size_; ++pivot)
      if (pivot != cut) text += joint(pivot, cut);
    text += "r_joint extra { ref_frame { " + place(2, cut, arm_, heights_[2]) + " " + turn_of_arm_ +
            " } } loops { cut { frames = left ~ right type = " + type + " } } ";
    text += "independent { extra";
    for (const int leader : leaders) text += ", " + name(leader);
    return text + " } }";
  }

  // Whether the position of the pivot is that of the tree's joint, or its opposite: links hang on their first pivots up
  // to the cut, and on their second ones behind it.
  static double sense(int pivot, int cut) { return pivot < cut ? 1.0 : -1.0; }

 private:
  struct Point {
    double x, y;
  };

  int size_;
  Dice dice_;
  std::vector<Point> pivots_;
  std::vector<double> heights_;  // of links
  std::vector<std::string> bodies_;
  Point arm_ = {};
  std::string turn_of_arm_;

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  double noise() { return dice_.between(-0.05, 0.05); }

  std::string body() {
    const double m = dice_.between(0.3, 2.0), s = dice_.between(0.002, 0.02);
    return fmt::format(
        "mass = {} CoM = ({}, {}, {}) Ix = {} Iy = {} Iz = {} Ixy = {} Ixz = {} Iyz = {}", m, noise(), noise(), noise(),
        3 * m * s, 2.5 * m * s, 3.5 * m * s, 0.2 * m * s, -0.1 * m * s, 0.15 * m * s);
  }

  static bool is_before(int link, int cut) { return link <= cut; }

  // Of the link's frame, at q = 0.
  Point origin(int link, int cut) const {
    if (link == 0) return {0, 0};
    return is_before(link, cut) ? pivots_[at(link - 1)] : pivots_[at(link)];
  }

  std::string place(int link, int cut, const Point& p, double height) const {
    const Point o = origin(link, cut);
    return fmt::format("translation = ({}, {}, {})", p.x - o.x, p.y - o.y, height - heights_[at(link)]);
  }

  std::string children(int link, int cut) const {
    std::string text = "children { ";
    const auto add = [&](int child, int pivot) { text += fmt::format("link{} via {} ", child, name(pivot)); };
    if (link < cut) add(link + 1, link);
    if (link == 0 && cut < size_ - 1) add(size_ - 1, size_ - 1);
    if (link > cut + 1) add(link - 1, link - 1);
    if (link == 2) text += "arm via extra ";
    return text + "} ";
  }

  std::string frames(int link, int cut) const {
    std::string text;
    const auto add = [&](const std::string& frame, const Point& p, double height) {
      text += fmt::format("{} {{ {} rotation = (0.0, 0.0, 0.0) }} ", frame, place(link, cut, p, height));
    };
    if (link > 0) add(fmt::format("body{}", link), pivots_[at(link - 1)], heights_[at(link)]);
    if (link == cut) add("left", pivots_[at(cut)], heights_[at(cut)]);
    if (link == (cut + 1) % size_) add("right", pivots_[at(cut)], heights_[at(cut)]);
    return text.empty() ? "" : "frames { " + text + "} ";
  }

  std::string joint(int pivot, int cut) const {
    const int next = (pivot + 1) % size_;
    const int parent = pivot < cut ? pivot : next, child = pivot < cut ? next : pivot;
    return fmt::format(
        "r_joint {} {{ ref_frame {{ {} rotation = (0.0, 0.0, 0.0) }} }} ", name(pivot),
        place(parent, cut, pivots_[at(pivot)], heights_[at(child)]));
  }
};

model::KinematicTree tree_of(const std::string& text) {
  Diagnostics diagnostics;
  auto tree = import::kinematic_tree(
      language::kinematics::parse(std::make_shared<const Source>("ring.kindsl", text), diagnostics), diagnostics);
  if (!tree) throw std::runtime_error(diagnostics.render() + text);
  return *std::move(tree);
}

// Of the pivots in their order, then of the joint `extra`.
struct PivotMotion {
  Vector<Real> position, velocity, acceleration;
};

// All turns along the ring together are none.
PivotMotion motion_of_pivots(
    const Ring& ring,
    int cut,
    const reflection::Robot& tables,
    const reference::Motion<double>& motion) {
  reference::Motion<double> of_loops = motion;
  const reference::AtLoops closed(tables, of_loops);
  const Vector<Real> joints[] = {
      reference::joint_positions(closed.robot(), motion.q.cast<Real>()),
      reference::joint_rates(closed.robot(), motion.qd.cast<Real>()),
      reference::joint_rates(closed.robot(), motion.qdd.cast<Real>()) + of_loops.of_loops.cast<Real>()};
  std::map<std::string, int> index;
  for (int j = 0; j < tables.joints.size; ++j) index[tables.joints[j].name] = j;
  PivotMotion result;
  Vector<Real>* results[] = {&result.position, &result.velocity, &result.acceleration};
  for (int k = 0; k < 3; ++k) {
    Vector<Real>& turns = *results[k];
    turns = Vector<Real>(ring.size() + 1);
    for (int pivot = 0; pivot < ring.size(); ++pivot) {
      if (pivot == cut) continue;
      turns(pivot) = static_cast<Real>(Ring::sense(pivot, cut)) * joints[k](index.at(Ring::name(pivot)));
      turns(cut) -= turns(pivot);
    }
    turns(ring.size()) = joints[k](index.at("extra"));
  }
  return result;
}

// The pivots that lead, by coordinate; `extra` is the one behind the last pivot.
std::vector<int> coordinates(const Ring& ring, const reflection::Robot& tables) {
  std::vector<int> pivots;
  for (int c = 0; c < tables.dof(); ++c) {
    int pivot = 0;
    while (pivot < ring.size() && Ring::name(pivot) != tables.joints[c].name) ++pivot;
    pivots.push_back(pivot);
  }
  return pivots;
}

std::vector<std::vector<int>> choices_of_leaders(int size, int cut) {
  std::vector<std::vector<int>> choices;
  for (int a = 0; a < size; ++a) {
    if (a == cut) continue;
    if (size == 4) choices.push_back({a});
    for (int b = a + 1; size == 5 && b < size; ++b)
      if (b != cut) choices.push_back({a, b});
  }
  return choices;
}

class CutLoops : public testing::TestWithParam<int> {};

TEST_P(CutLoops, MoveAlikeWhereverTheyAreCut) {
  for (int i = 0; i < std::max(1, robot_count() / 500); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const Ring ring(GetParam(), seed);
    Dice dice(seed + 100);
    const auto draw = [&](int size, double limit) {
      Vector<double> v(size);
      for (int k = 0; k < size; ++k) v(k) = dice.between(-limit, limit);
      return v;
    };
    const Vector<double> gravity = draw(3, 10.0);
    const int size = ring.size(), dof = size - 2;
    reference::Motion<double> motion;
    motion.q = draw(dof, 0.2), motion.qd = draw(dof, 1.0);
    const double force_of_extra = dice.between(-5, 5);
    // Forward dynamics with a force of the joint `extra` alone.
    const auto acceleration = [&](const InterpretedRobot& robot, const reference::Motion<double>& state) {
      const std::vector<int> leaders = coordinates(ring, robot.tables());
      Vector<double> tau(dof);
      for (int c = 0; c < dof; ++c) tau(c) = leaders[static_cast<std::size_t>(c)] == size ? force_of_extra : 0.0;
      return robot.forward_dynamics(state, tau, {&gravity, nullptr});
    };
    PivotMotion expected;
    int documents = 0;
    for (int cut = 0; cut < size; ++cut)
      for (const std::vector<int>& leaders : choices_of_leaders(size, cut)) {
        const std::string text = ring.document(cut, leaders, cut % 2 == 0 ? "hinge" : "point");
        const InterpretedRobot robot(tree_of(text), {}, {}, {}, {}, {"forward_dynamics"});
        const std::vector<int> of = coordinates(ring, robot.tables());
        ASSERT_EQ(static_cast<int>(of.size()), dof) << text;
        if (documents++ == 0) {
          // Where the loop closes.
          for (int tries = 0; tries < 20 && !reference::AtLoops(robot.tables(), motion).is_usual(); ++tries)
            motion.q = draw(dof, 0.2);
          motion.of_loops = {};
          motion.qdd = acceleration(robot, motion);
          expected = motion_of_pivots(ring, cut, robot.tables(), motion);
          continue;
        }
        const auto sense = [&](int c) {
          const int pivot = of[static_cast<std::size_t>(c)];
          return pivot == size ? 1.0 : Ring::sense(pivot, cut);
        };
        reference::Motion<double> same = motion;
        for (int c = 0; c < dof; ++c) {
          same.q(c) = sense(c) * static_cast<double>(expected.position(of[static_cast<std::size_t>(c)]));
          same.qd(c) = sense(c) * static_cast<double>(expected.velocity(of[static_cast<std::size_t>(c)]));
        }
        const Vector<double> found = acceleration(robot, same);
        const double scale = 1 + static_cast<double>(reference::largest(expected.acceleration));
        for (int c = 0; c < dof; ++c)
          EXPECT_NEAR(
              sense(c) * found(c), static_cast<double>(expected.acceleration(of[static_cast<std::size_t>(c)])),
              kSame * scale)
              << "seed " << seed << ", cut at " << cut << ": " << text;
        if (HasFailure()) return;
      }
    EXPECT_EQ(documents, size == 4 ? 12 : 30);
  }
}

INSTANTIATE_TEST_SUITE_P(OfBars, CutLoops, testing::Values(4, 5));

}  // namespace
}  // namespace robcogen::numeric
