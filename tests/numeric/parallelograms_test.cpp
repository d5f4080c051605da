// Followers in parallelograms are sums of other joints: in all positions, flat ones included, and as Newton's method
// closes them.
#include <gtest/gtest.h>

#include "document_tree.h"
#include "interpreted_robot.h"
#include "ring_robot.h"
#include "volume.h"

namespace robcogen::numeric::parallelograms_test {
namespace {

using reference::Real;
using reference::Vector;

int ring_count() {
  return std::max(2, robot_count() / 1000);
}

// Checks all choices of the cut pivot and of the leading joint.
void for_each_document(Ring::Shape shape, const std::function<void(const std::string&, std::uint64_t seed)>& check) {
  for (int i = 0; i < ring_count(); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const Ring ring(4, seed, shape);
    for (int cut = 0; cut < ring.size(); ++cut)
      for (const std::vector<int>& leaders : ring.choices_of_leaders(cut)) {
        check(ring.document(cut, leaders, cut % 2 == 0 ? "hinge" : "point"), seed);
        if (testing::Test::HasFailure()) return;
      }
  }
}

class Parallelograms : public testing::TestWithParam<Ring::Shape> {};

TEST_P(Parallelograms, StayClosedInAllPositions) {
  constexpr double kClosed = 1e-15;  // m
  for_each_document(GetParam(), [&](const std::string& text, std::uint64_t seed) {
    const model::KinematicTree tree = tree_of_text(text);
    EXPECT_TRUE(tree.closures.empty()) << text;
    EXPECT_EQ(tree.couplings.size(), 2U) << text;
    const InterpretedRobot robot(tree, {}, {}, {}, {}, {"joint_positions"});
    const reflection::Robot tables = robot.tables();
    std::mt19937_64 engine(seed);
    for (int state = 0; state < 5; ++state) {
      const Vector<Real> q = reference::uniform_vector(engine, tables.dof(), 4.0).cast<Real>();
      const Vector<Real> joints = reference::joint_positions(tables, q);
      EXPECT_LT(static_cast<double>(reference::largest(reference::loop_rows(tables, joints).error)), kClosed) << text;
    }
  });
}

TEST_P(Parallelograms, AgreeWithTheReferenceInAllFunctions) {
  for_each_document(GetParam(), [&](const std::string& text, std::uint64_t seed) {
    const InterpretedRobot robot(tree_of_text(text), {});
    EXPECT_TRUE(robot.programs().contains("coriolis_matrix"));
    EXPECT_TRUE(robot.programs().contains("inverse_dynamics_derivatives"));
    EXPECT_EQ(check_all(robot, seed, 1).failure_report(), "") << text;
  });
}

INSTANTIATE_TEST_SUITE_P(
    OfShape,
    Parallelograms,
    testing::Values(Ring::Shape::parallelogram, Ring::Shape::flat),
    [](const auto& shape) { return shape.param == Ring::Shape::flat ? "flat" : "open"; });

// The same tables, but with general loops: all that is known of them is that they close.
TEST(OpenParallelograms, MoveAsNewtonsMethodClosesThem) {
  constexpr double kSame = 1e-12;
  for_each_document(Ring::Shape::parallelogram, [&](const std::string& text, std::uint64_t seed) {
    const InterpretedRobot robot(tree_of_text(text), {}, {}, {}, {}, {"forward_dynamics"});
    const reflection::Robot tables = robot.tables();
    std::vector<reflection::Coupling> couplings(tables.couplings.begin(), tables.couplings.end());
    for (reflection::Coupling& coupling : couplings) coupling.offset = std::numeric_limits<double>::quiet_NaN();
    reflection::Robot general = tables;
    general.couplings.data = couplings.data();
    std::mt19937_64 engine(seed);
    reference::Motion<double> motion;
    motion.q = reference::uniform_vector(engine, tables.dof(), 0.3);
    motion.qd = reference::uniform_vector(engine, tables.dof(), 2.0);
    const reference::AtLoops closed(general, motion);
    ASSERT_TRUE(closed.is_usual()) << text;
    const auto same = [&](const Vector<Real>& found, const Vector<Real>& expected) {
      EXPECT_LT(static_cast<double>(reference::largest(found - expected)), kSame) << text;
    };
    const Vector<Real> q = motion.q.cast<Real>(), qd = motion.qd.cast<Real>();
    same(reference::joint_positions(tables, q), reference::joint_positions(closed.robot(), q));
    same(reference::joint_rates(tables, qd), reference::joint_rates(closed.robot(), qd));
    EXPECT_LT(reference::largest(motion.of_loops), kSame);
  });
}

// A four-bar drives one side of a parallelogram, so no joint follows in proportion.
TEST(ParallelogramsBehindOtherLoops, AreClosedAsOthers) {
  const auto body = [](const std::string& name, const std::string& rest) {
    return "link " + name +
           " { id = 1 inertia_params { mass = 1.2 CoM = (0.1, 0.02, 0.01) Ix = 0.03 Iy = 0.04 Iz = 0.05 Ixy = 0.001 "
           "Ixz = 0.0 Iyz = 0.002 } " +
           rest + " } ";
  };
  const auto frame = [](const std::string& name, double x) {
    return name + " { translation = (" + std::to_string(x) + ", 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } ";
  };
  const auto joint = [](const std::string& name, double x, double angle) {
    return "r_joint " + name + " { ref_frame { translation = (" + std::to_string(x) +
           ", 0.0, 0.0) rotation = (0.0, 0.0, " + std::to_string(angle) + ") } } ";
  };
  const std::string text =
      "Robot Two { RobotBase base { children { crank via x left via a right via c } } " +
      body("crank", "children { rod via y }") + body("rod", "children {} frames { " + frame("end", 0.55) + "}") +
      body("left", "children { top via b } frames { " + frame("pin", 0.4) + "}") +
      body("top", "children {} frames { " + frame("top_end", 0.3) + "}") +
      body("right", "children {} frames { " + frame("right_pin", 0.25) + "}") + joint("x", 0.0, 1.2) +
      joint("y", 0.2, -0.8) + joint("a", 0.5, 1.4) + joint("b", 0.25, -1.4) + joint("c", 0.8, 1.4) +
      "loops { bar { frames = end ~ pin type = hinge } sides { frames = top_end ~ right_pin type = point } } "
      "independent { x } }";
  const model::KinematicTree tree = tree_of_text(text);
  EXPECT_EQ(tree.closures.size(), 2U);
  const InterpretedRobot robot(tree, {});
  EXPECT_EQ(check_all(robot, 1, 5).failure_report(), "");
}

}  // namespace
}  // namespace robcogen::numeric::parallelograms_test
