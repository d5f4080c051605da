// Robots with loops over time: without dissipation they conserve energy.
#include <gtest/gtest.h>

#include "document_tree.h"
#include "interpreted_robot.h"
#include "runge_kutta.h"

namespace robcogen::numeric::loop_motions_test {
namespace {

using reference::Motion;
using reference::Vector;

const Vector<double> kGravity{0, 0, -9.81};

constexpr double kDuration = 10.0;  // s
constexpr double kDrift = 1e-8;     // relative to the energy that is exchanged

// A robot of the folder `robots`. Springs on its coordinates hold it near q = 0, where its loops are not flat.
struct Held {
  std::string name;
  Vector<double> stiffness;  // N m/rad, N/m
  Vector<double> velocity;   // at the start
  int steps;                 // per second
};

void PrintTo(const Held& held, std::ostream* out) {
  *out << held.name;
}

// Returns the robot without damping and friction.
model::KinematicTree conservative(const std::string& name) {
  model::KinematicTree tree = tree_of_robot(ROBCOGEN_ROBOTS_DIR, name);
  tree.uses_passive_forces = false;
  return tree;
}

class HeldMotion {
 public:
  explicit HeldMotion(const Held& held)
      : held_(held),
        robot_(conservative(held.name), {}, all_steps(), {}, {}, {"forward_dynamics"}),
        q_(held.velocity.rows()),
        qd_(held.velocity) {}

  void step() {
    runge_kutta_step(
        1.0 / held_.steps, [&](const auto& q, const auto& qd) { return acceleration(q, qd); }, q_, qd_);
  }

  // The reference computes the energies; it closes the loops by Newton's method.
  double kinetic() const {
    Motion<double> motion = moving();
    const reference::AtLoops closed(tables(), motion);
    return reference::kinetic_energy(closed.robot(), motion);
  }
  double potential() const {
    Motion<double> motion = moving();
    const reference::AtLoops closed(tables(), motion);
    double energy = reference::potential_energy(closed.robot(), q_, kGravity);
    for (int k = 0; k < q_.rows(); ++k) energy += held_.stiffness(k) * q_(k) * q_(k) / 2;
    return energy;
  }

 private:
  const Held& held_;
  InterpretedRobot robot_;
  Vector<double> q_, qd_;

  reflection::Robot tables() const { return robot_.tables(); }

  Motion<double> moving() const {
    Motion<double> motion = reference::at_rest(q_);
    motion.qd = qd_;
    return motion;
  }

  Vector<double> acceleration(const Vector<double>& q, const Vector<double>& qd) const {
    Motion<double> motion = reference::at_rest(q);
    motion.qd = qd;
    Vector<double> tau(q.rows());
    for (int k = 0; k < tau.rows(); ++k) tau(k) = -held_.stiffness(k) * q(k);
    return robot_.forward_dynamics(motion, tau, {&kGravity, nullptr});
  }
};

class LoopMotions : public testing::TestWithParam<Held> {};

TEST_P(LoopMotions, KeepTheirEnergy) {
  HeldMotion motion(GetParam());
  const double kinetic = motion.kinetic(), before = kinetic + motion.potential();
  double least = kinetic, most = kinetic;
  const int steps = static_cast<int>(kDuration * GetParam().steps);
  for (int k = 1; k <= steps; ++k) {
    motion.step();
    if (k % (steps / 100) != 0) continue;
    const double now = motion.kinetic();
    least = std::min(least, now), most = std::max(most, now);
  }
  // Kinetic and potential energy were exchanged.
  EXPECT_LT(least, most / 2);
  const double drift = motion.kinetic() + motion.potential() - before;
  RecordProperty("relative_drift", std::to_string(drift / most * 1e12) + "e-12");
  EXPECT_LT(std::abs(drift), kDrift * most) << "of " << most << " J at most";
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    LoopMotions,
    testing::Values(
        Held{"five_bar", {2, 2}, {2, -1}, 1000},
        Held{"four_bar_leg", {500, 60, 30}, {0.3, -0.5, 1}, 2000},
        Held{"palletiser", {300, 400, 400}, {0.5, 0.3, -0.4}, 1000},
        Held{"delta", {40, 40, 60}, {0.3, -0.2, 0.3}, 1000},
        Held{"achilles_leg", {4, 4}, {0.5, 1}, 1000}),
    [](const auto& held) { return held.param.name; });

}  // namespace
}  // namespace robcogen::numeric::loop_motions_test
