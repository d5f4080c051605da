// Robots with loops over time: without dissipation they keep their energy.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "import/kinematics.h"
#include "import/parts.h"
#include "interpreted_robot.h"

namespace robcogen::numeric {
namespace {

using reference::Motion;
using reference::Vector;

const Vector<double> kGravity{0, 0, -9.81};

constexpr double kDuration = 10.0;  // s
constexpr double kDrift = 1e-8;     // relative to the energy that is exchanged

// A robot of the folder robots, held near q = 0, where its loops are open, by springs on its coordinates.
struct Held {
  std::string name;
  Vector<double> stiffness;  // N m/rad, N/m
  Vector<double> velocity;   // at the start
  int steps;                 // a second
};

void PrintTo(const Held& held, std::ostream* out) {
  *out << held.name;
}

// Without damping and friction.
model::KinematicTree conservative(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / name / (name + ".kindsl");
  std::ifstream file(path, std::ios::binary);
  const auto source =
      std::make_shared<const Source>(path.string(), std::string(std::istreambuf_iterator<char>(file), {}));
  Diagnostics diagnostics;
  const auto read = import::robot_document(source, {}, diagnostics);
  auto tree = read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
  if (!tree) throw std::runtime_error(diagnostics.render());
  tree->uses_passive_forces = false;
  return *std::move(tree);
}

class HeldMotion {
 public:
  explicit HeldMotion(const Held& held)
      : held_(held),
        robot_(conservative(held.name), {}, all_steps(), {}, {}, {"forward_dynamics"}),
        q_(held.velocity.rows()),
        qd_(held.velocity) {}

  void step() {
    const double h = 1.0 / held_.steps;
    const Vector<double> a1 = acceleration(q_, qd_), v1 = qd_;
    const Vector<double> v2 = qd_ + h / 2 * a1, a2 = acceleration(q_ + h / 2 * v1, v2);
    const Vector<double> v3 = qd_ + h / 2 * a2, a3 = acceleration(q_ + h / 2 * v2, v3);
    const Vector<double> v4 = qd_ + h * a3, a4 = acceleration(q_ + h * v3, v4);
    q_ = q_ + h / 6 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    qd_ = qd_ + h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }

  // By the reference, which closes the loops by Newton's method.
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
  // Energy went to and fro.
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
}  // namespace robcogen::numeric
