// Dynamics of all joints with the loops cut and held by forces: compared with the reduced dynamics where the loops are
// closed, and with dense equations of the tree with constraints where they are open.
#include <gtest/gtest.h>

#include <algorithm>

#include "document_tree.h"
#include "interpreted_robot.h"
#include "iterative_robot.h"
#include "looped_robot.h"
#include "model/plausibility.h"
#include "open_loops.h"
#include "ring_robot.h"
#include "runge_kutta.h"
#include "volume.h"

namespace robcogen::numeric::loop_dynamics_test {
namespace {

using reference::Matrix;
using reference::Real;
using reference::Vector;

const char* const kFunction = "loop_constrained_forward_dynamics";

// The base comes first, if it floats.
Vector<double> accelerations_of(const symbolic::Arrays<double>& results) {
  std::vector<double> all;
  if (const auto base = results.find("base_acceleration"); base != results.end()) all = base->second;
  const std::vector<double>& joints = results.at("accelerations");
  all.insert(all.end(), joints.begin(), joints.end());
  Vector<double> result(static_cast<int>(all.size()));
  for (int k = 0; k < result.rows(); ++k) result(k) = all[static_cast<std::size_t>(k)];
  return result;
}

void expect_same(const std::vector<double>& found, const std::vector<double>& wanted, double tolerance) {
  ASSERT_EQ(found.size(), wanted.size());
  double size = 1;
  for (const double x : wanted) size = std::max(size, std::abs(x));
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found[k], wanted[k], tolerance * size) << k;
}

class LoopDynamics {
 public:
  LoopDynamics(const model::KinematicTree& tree, const std::vector<std::string>& steps, std::uint64_t seed)
      : tree_(tree),
        robot_(tree, {}, steps, values_near_defaults(tree), {}, {"forward_dynamics", "inverse_dynamics", "transforms"}),
        tables_(robot_.tables()),
        engine_(seed),
        closed_(draw(engine_, tables_, sample_)) {}

  // Followers have no motors.
  void expect_reduced_dynamics() {
    constexpr double kSame = 1e-10, kSameForces = 1e-9;
    reference::Motion<double> m = sample_.motion;
    const reference::Arguments arguments{&sample_.gravity, &sample_.external};
    const Vector<double> tau = reference::uniform_vector(engine_, tables_.dof(), 5.0);
    symbolic::Arrays<double> inputs = {
        {"q", m.q.values()}, {"qd", m.qd.values()}, {"tau", tau.values()}, {"base_velocity", m.base_velocity.values()}};
    const auto reduced = robot_.run("forward_dynamics", arguments, inputs);
    inputs["qdd"] = reduced.at("qdd");
    if (tables_.floating_base) inputs["base_acceleration"] = reduced.at("base_acceleration");
    std::vector<double> joint_forces = tau.values();
    joint_forces.resize(static_cast<std::size_t>(tables_.joints.size));
    inputs["positions"] = robot_.run("joint_positions", {}, inputs).at("positions");
    inputs["velocities"] = robot_.run("joint_velocities", {}, inputs).at("velocities");
    inputs["joint_forces"] = joint_forces;
    inputs["stabilization"] = {7.0, 3.0};
    inputs["compliance"] = {0.0};
    const auto found = robot_.run(kFunction, arguments, inputs);
    expect_same(found.at("accelerations"), robot_.run("joint_accelerations", {}, inputs).at("accelerations"), kSame);
    if (tables_.floating_base) expect_same(found.at("base_acceleration"), reduced.at("base_acceleration"), kSame);
    expect_same(found.at("loop_forces"), robot_.run("loop_forces", arguments, inputs).at("forces"), kSameForces);
  }

  // Any state near closed ones; its velocities need not keep the loops closed.
  void expect_dense_solution() {
    constexpr double kSame = 1e-9;
    const int base = tables_.floating_base ? 6 : 0, n = tables_.joints.size;
    const auto parted = [&](const Vector<double>& v) { return v.cast<Real>(); };
    reference::Motion<Real> all = reference::cast<Real>(sample_.motion);
    const Vector<double> closed = reference::joint_positions(closed_.robot(), all.q).cast<double>();
    const Vector<double> positions = closed + reference::uniform_vector(engine_, n, 0.03);
    const Vector<double> velocities = reference::uniform_vector(engine_, n, 2.0);
    const Vector<double> tau = reference::uniform_vector(engine_, n, 5.0);
    const double position_gain = 50.0, velocity_gain = 6.0;
    symbolic::Arrays<double> inputs = {
        {"positions", positions.values()},
        {"velocities", velocities.values()},
        {"joint_forces", tau.values()},
        {"base_velocity", sample_.motion.base_velocity.values()},
        {"stabilization", {position_gain, velocity_gain}},
        {"compliance", {0.0}}};
    const auto results = robot_.run(kFunction, {&sample_.gravity, &sample_.external}, inputs);
    const Vector<Real> found = accelerations_of(results).cast<Real>();

    const reflection::Robot free = reference::with_free_joints(tables_);
    all.q = parted(positions), all.qd = parted(velocities), all.of_loops = {};
    reference::Loads<Real> loads{sample_.gravity.cast<Real>(), {}, true};
    for (const Vector<double>& wrench : sample_.external) loads.external.push_back(wrench.cast<Real>());
    const reference::Forces<Real> bias = reference::bias_forces(free, all, loads);
    Vector<Real> missing = parted(tau) - bias.tau;
    if (base > 0) missing = reference::stacked(-bias.base_wrench, missing);
    const Matrix<Real> H = reference::joint_space_inertia(free, all.q);
    const OpenLoops open = open_loops(tree_, tables_, all.q);
    const Vector<Real> v = base > 0 ? reference::stacked(Vector<Real>(6), all.qd) : all.qd;
    Vector<Real> wanted = -change_of_rates(tree_, tables_, all.q, all.qd);
    wanted = wanted - static_cast<Real>(velocity_gain) * (open.K * v) - static_cast<Real>(position_gain) * open.error;
    // A tiny compliance regularises redundant rows.
    Matrix<Real> W = open.K * solve(H, transpose(open.K));
    const Real trace = reference::largest(W);
    for (int k = 0; k < W.rows(); ++k) W(k, k) += 1e-16L * trace;
    const Vector<Real> f = solve(W, wanted - open.K * solve(H, missing));
    const Vector<Real> expected = solve(H, missing + transpose(open.K) * f);
    const Real size = 1 + reference::largest(expected);
    EXPECT_LT(static_cast<double>(reference::largest(found - expected) / size), kSame);

    // The loop forces produce this motion.
    std::size_t next = 0;
    for (int loop = 0; loop < tables_.loops.size; ++loop)
      push(tree_, tables_, all.q, loop, results.at("loop_forces"), next, loads.external);
    EXPECT_EQ(next, results.at("loop_forces").size());
    all.base_acceleration = base > 0 ? found.head(6) : Vector<Real>(6);
    all.qdd = found.tail(n);
    const reference::Forces<Real> needed = reference::inverse_dynamics_fully_actuated(free, all, loads);
    Vector<Real> left = parted(tau) - needed.tau;
    const std::vector<int> couplings = declared_couplings(tree_);
    ASSERT_EQ(results.contains("coupling_forces"), !couplings.empty());
    for (std::size_t k = 0; k < couplings.size(); ++k) {
      const Real force = static_cast<Real>(results.at("coupling_forces").at(k));
      const int follower = tables_.dof() + couplings[k];
      left(follower) += force;
      for (const reference::Mover& mover : reference::movers_of(tables_, follower))
        left(mover.coordinate) -= static_cast<Real>(mover.factor) * force;
    }
    const Real of_forces = 1 + reference::largest(f) + reference::largest(missing);
    EXPECT_LT(static_cast<double>(reference::largest(left) / of_forces), kSame);
    if (base == 0) return;
    EXPECT_LT(static_cast<double>(reference::largest(needed.base_wrench) / of_forces), kSame);
  }

 private:
  const model::KinematicTree& tree_;
  InterpretedRobot robot_;
  reflection::Robot tables_;
  std::mt19937_64 engine_;
  reference::Sample sample_;
  reference::AtLoops closed_;
};

void expect_all(const model::KinematicTree& tree, std::uint64_t seed) {
  LoopDynamics dynamics(tree, seed % 3 == 0 ? all_steps() : std::vector<std::string>{}, seed);
  dynamics.expect_reduced_dynamics();
  dynamics.expect_dense_solution();
}

TEST(LoopDynamics, OfRandomRobots) {
  for (int i = 0; i < std::max(12, robot_count() / 40); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    if (const auto tree = looped_tree(seed)) expect_all(*tree, seed);
    if (testing::Test::HasFailure()) FAIL() << seed << "\n" << looped_document(seed);
  }
}

class IterativeLoopDynamics : public testing::TestWithParam<IterativeRobot> {};

TEST_P(IterativeLoopDynamics, AreThoseOfTheTreeWithConstraints) {
  model::KinematicTree tree = tree_of_text(GetParam().document);
  for (const bool floats : {false, true}) {
    tree.floating_base = floats;
    for (std::uint64_t seed = 2; seed < 4; ++seed) expect_all(tree, seed);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Mechanism,
    IterativeLoopDynamics,
    testing::ValuesIn(iterative_robots()),
    [](const testing::TestParamInfo<IterativeRobot>& of) { return of.param.name; });

TEST(LoopDynamics, OfParallelograms) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Ring ring(4, seed, Ring::Shape::parallelogram);
    for (int cut = 0; cut < ring.size(); ++cut)
      for (const std::vector<int>& leaders : ring.choices_of_leaders(cut))
        expect_all(tree_of_text(ring.document(cut, leaders, cut % 2 == 0 ? "hinge" : "point")), seed);
  }
}

class LoopDynamicsOfRobots : public testing::TestWithParam<std::string> {};

TEST_P(LoopDynamicsOfRobots, AreThoseOfTheTreeWithConstraints) {
  model::KinematicTree tree = tree_of_robot(ROBCOGEN_ROBOTS_DIR, GetParam());
  for (const bool floats : {false, true}) {
    tree.floating_base = floats;
    if (model::inertia_defects(tree).is_singular()) continue;  // a base without mass
    for (std::uint64_t seed = 0; seed < 3; ++seed) expect_all(tree, seed);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    LoopDynamicsOfRobots,
    testing::Values("achilles_leg", "ankle", "delta", "five_bar", "four_bar_leg", "palletiser"),
    [](const auto& robot) { return robot.param; });

// When all links are on one line, rows of the loop are redundant.
TEST(LoopDynamics, PassStretchedPositionsWithCompliance) {
  const Ring ring(4, 1, Ring::Shape::flat);
  const InterpretedRobot robot(
      tree_of_text(ring.document(0, ring.choices_of_leaders(0).front(), "hinge")), {}, {}, {}, {},
      {"forward_dynamics"});
  const int n = robot.tables().joints.size;
  const std::vector<double> some(static_cast<std::size_t>(n), 0.3), none(static_cast<std::size_t>(n));
  symbolic::Arrays<double> inputs = {
      {"positions", none}, {"velocities", none}, {"joint_forces", some}, {"stabilization", {0, 0}}};
  const auto accelerations = [&](double compliance) {
    inputs["compliance"] = {compliance};
    return robot.run(kFunction, {}, inputs).at("accelerations");
  };
  for (const double a : accelerations(1e-8)) EXPECT_TRUE(std::isfinite(a)) << a;
  expect_same(accelerations(1e-8), accelerations(1e-6), 1e-3);
  // A loop that yields to any force is not held.
  inputs["compliance"] = {1e12};
  const std::vector<double> forces = robot.run(kFunction, {}, inputs).at("loop_forces");
  for (const double force : forces) EXPECT_NEAR(force, 0.0, 1e-9);
}

// A five-bar that starts open is pulled together while it moves.
TEST(LoopDynamics, CloseLoopsOverTime) {
  const InterpretedRobot robot(
      tree_of_robot(ROBCOGEN_ROBOTS_DIR, "five_bar"), {}, {}, {}, {}, {"forward_dynamics", "transforms"});
  const int n = robot.tables().joints.size;
  const auto closed = robot.run("joint_positions", {}, {{"q", {0.1, -0.1}}}).at("positions");
  Vector<double> q(n), qd(n);
  for (int k = 0; k < n; ++k) q(k) = closed[static_cast<std::size_t>(k)];
  q(n - 1) += 0.05;
  const auto gap = [&] {
    double largest = 0;
    const std::vector<double> open = robot.run("loop_error", {}, {{"positions", q.values()}}).at("error");
    for (const double e : open) largest = std::max(largest, std::abs(e));
    return largest;
  };
  const auto acceleration = [&](const Vector<double>& p, const Vector<double>& v) {
    const std::vector<double> forces(static_cast<std::size_t>(n));
    return accelerations_of(robot.run(
        kFunction, {},
        {{"positions", p.values()},
         {"velocities", v.values()},
         {"joint_forces", forces},
         {"stabilization", {400, 40}},
         {"compliance", {0}}}));
  };
  const double start = gap();
  for (int step = 0; step < 1000; ++step) runge_kutta_step(1e-3, acceleration, q, qd);
  // The gap decays as (1 + 20 t) exp(-20 t).
  EXPECT_GT(start, 1e-3);
  EXPECT_LT(gap(), start * 1e-6);
}

}  // namespace
}  // namespace robcogen::numeric::loop_dynamics_test
