// One mechanism, cut at each of its pivots in turn and driven by each choice of its joints: every description gives the
// same motion of the links.
#include <gtest/gtest.h>

#include <map>

#include "dice.h"
#include "document_tree.h"
#include "interpreted_robot.h"
#include "ring_robot.h"
#include "volume.h"

namespace robcogen::numeric::cut_loops_test {
namespace {

using reference::Real;
using reference::Vector;

constexpr double kSame = 1e-10;

// One element per pivot, in order, then one for the joint `extra`.
struct PivotMotion {
  Vector<Real> position, velocity, acceleration;
};

// The rotations at the pivots around the ring sum to zero.
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
      reference::joint_accelerations(closed.robot(), of_loops).cast<Real>()};
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

// Returns the pivot of each coordinate; `extra` is the one after the last pivot.
std::vector<int> coordinates(const Ring& ring, const reflection::Robot& tables) {
  std::vector<int> pivots;
  for (int c = 0; c < tables.dof(); ++c) {
    int pivot = 0;
    while (pivot < ring.size() && Ring::name(pivot) != tables.joints[c].name) ++pivot;
    pivots.push_back(pivot);
  }
  return pivots;
}

struct Mechanism {
  std::string name;
  int size;
  Ring::Shape shape = Ring::Shape::any;
};

class CutLoops : public testing::TestWithParam<Mechanism> {};

TEST_P(CutLoops, MoveAlikeWhereverTheyAreCut) {
  for (int i = 0; i < std::max(1, robot_count() / 500); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const Ring ring(GetParam().size, seed, GetParam().shape);
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
    // Forward dynamics with a force at the joint `extra` only.
    const auto acceleration = [&](const InterpretedRobot& robot, const reference::Motion<double>& state) {
      const std::vector<int> leaders = coordinates(ring, robot.tables());
      Vector<double> tau(dof);
      for (int c = 0; c < dof; ++c) tau(c) = leaders[static_cast<std::size_t>(c)] == size ? force_of_extra : 0.0;
      return robot.forward_dynamics(state, tau, {&gravity, nullptr});
    };
    PivotMotion expected;
    int documents = 0;
    for (int cut = 0; cut < size; ++cut)
      for (const std::vector<int>& leaders : ring.choices_of_leaders(cut)) {
        const std::string text = ring.document(cut, leaders, cut % 2 == 0 ? "hinge" : "point");
        const InterpretedRobot robot(tree_of_text(text), {}, {}, {}, {}, {"forward_dynamics"});
        const std::vector<int> of = coordinates(ring, robot.tables());
        ASSERT_EQ(static_cast<int>(of.size()), dof) << text;
        if (documents++ == 0) {
          // Look for a position in which the loop closes.
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

INSTANTIATE_TEST_SUITE_P(
    Of,
    CutLoops,
    testing::Values(
        Mechanism{"four_bars", 4},
        Mechanism{"five_bars", 5},
        Mechanism{"parallelograms", 4, Ring::Shape::parallelogram},
        Mechanism{"flat_parallelograms", 4, Ring::Shape::flat}),
    [](const auto& mechanism) { return mechanism.param.name; });

}  // namespace
}  // namespace robcogen::numeric::cut_loops_test
