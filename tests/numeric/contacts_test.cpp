// Contact functions, Jacobians with base columns and the bias of the centroidal momentum on random robots, compared
// with dense equations of the reference in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "algorithm/catalogue/catalogue.h"
#include "coupled_robot.h"
#include "dice.h"
#include "interpreted_robot.h"
#include "pass/passes.h"
#include "random_drives.h"
#include "random_robot.h"
#include "reference_tables.h"
#include "robcogen/reference/check_contact_derivatives.h"
#include "robcogen/reference/contacts.h"
#include "robcogen/reference/samples.h"
#include "symbolic/interpret.h"
#include "volume.h"

namespace robcogen::numeric::contacts_test {
namespace {

using model::KinematicTree;
using reference::Arguments;
using reference::transpose;
using Real = long double;
using Matrix = reference::Matrix<Real>;
using Vector = reference::Vector<Real>;
using Values = std::vector<double>;

constexpr double kKinematics = 1e-11;
constexpr double kDigits = 1e-13;
constexpr double kDynamics = 1e-10;  // of the largest result; systems that lose more digits are skipped

double relative(const Matrix& found, const Matrix& wanted) {
  return static_cast<double>(reference::largest(found - wanted) / (1 + reference::largest(wanted)));
}

Matrix matrix(const Values& values, int rows) {
  Matrix m(rows, rows == 0 ? 0 : static_cast<int>(values.size()) / rows);
  for (std::size_t k = 0; k < values.size(); ++k) m.data()[k] = values[k];
  return m;
}

// A random robot with contacts, its programs and one state. Every third robot has drives, every third has couplings;
// half of the robots are computed in other link frames.
struct Case {
  explicit Case(std::uint64_t number, const std::vector<std::string>& groups) : dice(number + 77), seed(number) {
    KinematicTree tree = random_robot(seed, {.min_joints = 2, .max_joints = 14});
    if (seed % 3 == 0) tree = with_random_drives(std::move(tree), seed);
    CoupledRobot made{tree, {}};
    if (seed % 3 == 1) made = coupled(tree, seed, seed % 2 == 0);
    robot_tree = made.robot;
    parameters = made.parameters;
    desired = random_desired(seed, robot_tree);
    desired.contacts = random_contacts();
    robot = std::make_unique<InterpretedRobot>(
        robot_tree, desired, seed % 4 == 0 ? std::vector<std::string>() : all_steps(), parameters,
        seed % 4 < 2 ? algorithm::LinkFrames() : other_frames(), groups);
    tables = std::make_unique<reference::Tables>(reference_tables(robot_tree, parameters));
    std::mt19937_64 engine(seed);
    sample = reference::random_sample(engine, robot->tables());
    motion = reference::cast<Real>(sample.motion);
    for (const model::ContactFrame& contact : desired.contacts)
      tables->add_contact(frame_index(robot_tree, contact.frame), contact.is_surface);
    rows = reference::contact_rows(tables->robot());
  }

  std::vector<model::ContactFrame> random_contacts() {
    std::vector<model::ContactFrame> contacts;
    std::vector<model::Frame> frames;
    for (const model::Frame& frame : robot_tree.frames())
      if (robot_tree.floating_base || robot_tree.link_of(frame) != 0) frames.push_back(frame);
    const int count = 1 + dice.below(4);
    for (int c = 0; c < count && !frames.empty(); ++c) {
      const int k = dice.below(static_cast<int>(frames.size()));
      contacts.push_back({frames[static_cast<std::size_t>(k)], dice.chance(0.3)});
      frames.erase(frames.begin() + k);
    }
    return contacts;
  }

  algorithm::LinkFrames other_frames() {
    algorithm::LinkFrames frames(robot_tree.joints.size());
    for (algorithm::LinkFrame& frame : frames) {
      if (dice.chance(0.5)) frame.turn = model::Quantity(dice.between(-3, 3));
      if (dice.chance(0.5)) frame.slide = model::Quantity(dice.between(-0.5, 0.5));
      frame.turns_with_joint = dice.chance(0.5);
    }
    return frames;
  }

  bool floating() const { return robot_tree.floating_base; }
  int base() const { return floating() ? 6 : 0; }
  int size() const { return base() + robot_tree.dof(); }

  symbolic::Arrays<double> inputs() const {
    const reference::Motion<double>& m = sample.motion;
    return {
        {"q", m.q.values()},
        {"qd", m.qd.values()},
        {"qdd", m.qdd.values()},
        {"base_velocity", m.base_velocity.values()},
        {"base_acceleration", m.base_acceleration.values()}};
  }
  symbolic::Arrays<double> run(const std::string& name, symbolic::Arrays<double> more = {}) const {
    more.merge(inputs());
    return robot->run(name, arguments(), more);
  }
  // Runs a function that takes no loads.
  symbolic::Arrays<double> run_plain(const std::string& name, symbolic::Arrays<double> more = {}) const {
    more.merge(inputs());
    return robot->run(name, {}, more);
  }
  Arguments arguments() const { return {&sample.gravity, seed % 2 == 0 ? &sample.external : nullptr}; }
  reference::Loads<Real> loads() const {
    return reference::loads<Real>(
        sample.gravity, seed % 2 == 0 ? sample.external : std::vector<reference::Vector<double>>());
  }

  Matrix jacobian(const model::Frame& frame) const {
    return reference::jacobian_with_base(tables->robot(), motion.q, frame_index(robot_tree, frame));
  }
  Vector bias(const model::Frame& frame) const {
    return reference::bias_with_base(tables->robot(), motion, frame_index(robot_tree, frame));
  }
  Matrix contact_jacobian() const { return reference::contact_jacobian(tables->robot(), motion.q); }
  Vector contact_bias() const { return reference::contact_bias(tables->robot(), motion); }
  Matrix inertia() const { return reference::joint_space_inertia(tables->robot(), motion.q); }
  Vector velocity() const { return floating() ? reference::stacked(motion.base_velocity, motion.qd) : motion.qd; }
  Vector generalized(const reference::Forces<Real>& forces) const {
    return floating() ? reference::stacked(forces.base_wrench, forces.tau) : forces.tau;
  }
  Vector result(const symbolic::Arrays<double>& results, const char* of_base, const char* of_joints) const {
    const Vector joints = matrix(results.at(of_joints), robot_tree.dof());
    return floating() ? reference::stacked(matrix(results.at(of_base), 6), joints) : joints;
  }

  Values by_row(const Values& by_contact) const { return reference::by_row(tables->robot(), by_contact); }
  // Makes none, one, some or all of the contacts active.
  Values random_activity() {
    Values active(desired.contacts.size());
    const int kind = dice.below(4);
    for (double& a : active) a = kind == 3 || (kind == 2 && dice.chance(0.5)) ? 1 : 0;
    if (kind == 1) active[static_cast<std::size_t>(dice.below(static_cast<int>(active.size())))] = 1;
    return active;
  }
  Values random(int count, double low, double high) {
    Values values(static_cast<std::size_t>(count));
    for (double& x : values) x = dice.between(low, high);
    return values;
  }

  Dice dice;
  std::uint64_t seed;
  KinematicTree robot_tree;
  Values parameters;
  model::DesiredTransforms desired;
  std::unique_ptr<InterpretedRobot> robot;
  std::unique_ptr<reference::Tables> tables;
  reference::Sample sample;
  reference::Motion<Real> motion;
  int rows = 0;
};

// Calls check(case) for robots that have contacts, with the functions of one group; with `step`, for fewer robots.
template <class Check>
void for_each_case(const std::string& group, const Check& check, int step = 1) {
  const int count = std::max(100, robot_count() / 20);
  for (int i = 0; i < count; i += step) {
    Case c(static_cast<std::uint64_t>(i), {group});
    if (c.desired.contacts.empty() || c.robot->programs().empty()) continue;
    SCOPED_TRACE("seed " + std::to_string(i));
    check(c);
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << describe(c.robot_tree);
      return;
    }
  }
}

TEST(Contacts, JacobianVelocityAndBiasAreThoseOfTheFrames) {
  for_each_case("contacts", [](const Case& c) {
    const Matrix J = c.contact_jacobian();
    EXPECT_LT(relative(matrix(c.run_plain("contact_jacobian").at("J"), c.rows), J), kKinematics);
    EXPECT_LT(relative(matrix(c.run_plain("contact_velocity").at("velocity"), c.rows), J * c.velocity()), kKinematics);
    EXPECT_LT(relative(matrix(c.run_plain("contact_bias").at("bias"), c.rows), c.contact_bias()), kKinematics);
    const Matrix W = J * reference::solve(c.inertia(), transpose(J));
    const Matrix W_double =
        (J.cast<double>() * reference::solve(c.inertia().cast<double>(), transpose(J.cast<double>()))).cast<Real>();
    if (relative(W_double, W) > kDigits) return;
    EXPECT_LT(relative(matrix(c.run_plain("inverse_contact_inertia").at("W"), c.rows), W), kDynamics);
  });
}

TEST(Contacts, ForwardDynamicsSolvesTheDenseSystem) {
  int compared = 0, rigid = 0;
  for_each_case("contacts", [&](Case& c) {
    const Values tau = c.random(c.robot_tree.dof(), -20, 20), wanted = c.random(c.rows, -5, 5);
    const Values by_contact = c.random_activity(), active = c.by_row(by_contact);
    reference::Motion<Real> still = c.motion;
    const Vector bias = c.generalized(reference::bias_forces(c.tables->robot(), still, c.loads()));
    Vector forces(c.size());
    forces.set_block(c.base(), 0, matrix(tau, c.robot_tree.dof()));
    for (const bool is_rigid : {false, true}) {
      const Values compliance = c.random(c.rows, is_rigid ? 0 : 1e-3, is_rigid ? 0 : 1);
      const auto expected = reference::solve_contacts(
          c.inertia(), c.contact_jacobian(), forces - bias, matrix(wanted, c.rows) - c.contact_bias(), active,
          compliance, kDigits);
      if (!expected) continue;
      const auto results = c.run(
          "constrained_forward_dynamics",
          {{"tau", tau}, {"contact_acceleration", wanted}, {"active", by_contact}, {"compliance", compliance}});
      const Vector found = reference::stacked(
          c.result(results, "base_acceleration", "qdd"), matrix(results.at("contact_wrenches"), c.rows));
      EXPECT_LT(relative(found, *expected), kDynamics);
      for (int r = 0; r < c.rows; ++r)
        EXPECT_TRUE(
            active[static_cast<std::size_t>(r)] != 0 ||
            results.at("contact_wrenches")[static_cast<std::size_t>(r)] == 0.0);
      ++(is_rigid ? rigid : compared);
    }
  });
  EXPECT_GT(compared, 30);
  EXPECT_GT(rigid, 15);
}

TEST(Contacts, ImpactChangesVelocitiesByImpulses) {
  int compared = 0;
  for_each_case("contacts", [&](Case& c) {
    const Values by_contact = c.random_activity(), active = c.by_row(by_contact);
    const Values restitution = c.random(static_cast<int>(by_contact.size()), 0, 1);
    const Values compliance = c.random(c.rows, 1e-3, 1), e = c.by_row(restitution);
    const Matrix J = c.contact_jacobian();
    const Vector before = c.velocity(), at_contacts = J * before;
    Vector change(c.rows);
    for (int r = 0; r < c.rows; ++r) change(r) = -(1 + Real(e[static_cast<std::size_t>(r)])) * at_contacts(r);
    const auto expected =
        reference::solve_contacts(c.inertia(), J, Vector(c.size()), change, active, compliance, kDigits);
    if (!expected) return;
    const auto results =
        c.run_plain("impact", {{"restitution", restitution}, {"active", by_contact}, {"compliance", compliance}});
    const Vector after = c.result(results, "base_velocity_after", "qd_after");
    EXPECT_LT(relative(after, before + expected->head(c.size())), kDynamics);
    EXPECT_LT(relative(matrix(results.at("contact_impulses"), c.rows), expected->tail(c.rows)), kDynamics);
    ++compared;
  });
  EXPECT_GT(compared, 30);
}

TEST(Contacts, InverseDynamicsSubtractsGivenWrenches) {
  for_each_case("contacts", [](Case& c) {
    const Values wrenches = c.random(c.rows, -50, 50);
    const Vector without =
        c.generalized(reference::inverse_dynamics_fully_actuated(c.tables->robot(), c.motion, c.loads()));
    const Vector expected = without - transpose(c.contact_jacobian()) * matrix(wrenches, c.rows);
    const auto results = c.run("inverse_dynamics_with_contacts", {{"contact_wrenches", wrenches}});
    EXPECT_LT(relative(c.result(results, "base_wrench", "tau"), expected), kDynamics);
  });
}

// With the wrenches f and the multipliers y of the base: f / weights - J_b y = 0 and J_b^T f + r y = the wrench that
// the base needs.
TEST(Contacts, ConstrainedInverseDynamicsHasTheSmallestWrenches) {
  int compared = 0, open = 0;
  for_each_case("contacts", [&](Case& c) {
    EXPECT_EQ(c.robot->has("constrained_inverse_dynamics"), c.floating());
    if (!c.floating()) return;
    Values by_contact = c.random(static_cast<int>(c.desired.contacts.size()), 0.5, 2);
    if (by_contact.size() > 2) by_contact.front() = 0;
    const Values weights = c.by_row(by_contact);
    const double r = c.dice.chance(0.5) ? 0 : 0.3;
    const Matrix J = c.contact_jacobian();
    const Vector needed =
        c.generalized(reference::inverse_dynamics_fully_actuated(c.tables->robot(), c.motion, c.loads()));
    // Eliminates g = f / weights = J_b y, so that zero weights cause no division by zero.
    const Matrix J_b = J.block(0, 0, c.rows, 6);
    Matrix K(6, 6), G(c.rows, c.rows);
    for (int k = 0; k < c.rows; ++k) G(k, k) = weights[static_cast<std::size_t>(k)];
    K = transpose(J_b) * G * J_b + Real(r) * Matrix::identity(6);
    const Vector y = reference::solve(K, needed.head(6));
    const Vector in_double = reference::solve(K.cast<double>(), needed.head(6).cast<double>()).cast<Real>();
    if (!(relative(in_double, y) < kDigits)) return;
    const Vector f = G * J_b * y;
    const Vector expected = needed - transpose(J) * f;
    const auto results = c.run("constrained_inverse_dynamics", {{"weights", weights}, {"regularization", {r}}});
    EXPECT_LT(relative(matrix(results.at("contact_wrenches"), c.rows), f), kDynamics);
    EXPECT_LT(
        static_cast<double>(reference::largest(c.result(results, "base_wrench", "tau") - expected)),
        kDynamics * static_cast<double>(1 + reference::largest(needed) + reference::largest(f)));
    const Real missing = r == 0 ? reference::largest(expected.head(6)) : Real(0);
    EXPECT_LT(missing, kDynamics * (1 + reference::largest(needed)));
    ++compared;
    open += weights.front() == 0 ? 1 : 0;
  });
  EXPECT_GT(compared, 10);
  EXPECT_GT(open, 2);
}

// Moved along forces that the base does not feel, the wrenches cost more: the gradient f / weights - J_q U tau of the
// cost is J_b y, and J_b^T f + r y = the wrench that the base needs. Without torque weights, the torques do not count.
TEST(Contacts, MinimumTorqueInverseDynamicsHasTheSmallestTorques) {
  int compared = 0;
  for_each_case("contacts", [&](Case& c) {
    EXPECT_EQ(c.robot->has("minimum_torque_inverse_dynamics"), c.floating());
    if (!c.floating()) return;
    const int n = c.size() - 6;
    Values by_contact = c.random(static_cast<int>(c.desired.contacts.size()), 0.5, 2);
    if (by_contact.size() > 2) by_contact.front() = 0;
    const Values weights = c.by_row(by_contact);
    const Values torque_weights = c.random(n, 0, 2);
    const double r = 0.3;
    const Matrix J = c.contact_jacobian(), J_b = J.block(0, 0, c.rows, 6), J_q = J.block(0, 6, c.rows, n);
    const Vector needed =
        c.generalized(reference::inverse_dynamics_fully_actuated(c.tables->robot(), c.motion, c.loads()));
    const auto results = c.run(
        "minimum_torque_inverse_dynamics",
        {{"weights", weights}, {"torque_weights", torque_weights}, {"regularization", {r}}});
    const Vector f = matrix(results.at("contact_wrenches"), c.rows);
    const Vector left = needed - transpose(J) * f;  // r y, and the torques
    EXPECT_LT(
        static_cast<double>(reference::largest(c.result(results, "base_wrench", "tau") - left)),
        kDynamics * static_cast<double>(1 + reference::largest(needed) + reference::largest(f)));
    Vector costs = left.tail(n);
    for (int k = 0; k < n; ++k) costs(k) *= torque_weights[static_cast<std::size_t>(k)];
    Vector gradient = J_q * costs + Real(1 / r) * (J_b * left.head(6));
    for (int k = 0; k < c.rows; ++k) {
      const Real weight = weights[static_cast<std::size_t>(k)];
      if (weight == 0) {
        EXPECT_EQ(f(k), 0);
        gradient(k) = 0;
      } else {
        gradient(k) -= f(k) / weight;
      }
    }
    EXPECT_LT(
        static_cast<double>(reference::largest(gradient)),
        1e3 * kDynamics * static_cast<double>(1 + reference::largest(needed) + reference::largest(f)));

    const auto without = c.run(
        "minimum_torque_inverse_dynamics",
        {{"weights", weights}, {"torque_weights", Values(static_cast<std::size_t>(n))}, {"regularization", {r}}});
    const auto plain = c.run("constrained_inverse_dynamics", {{"weights", weights}, {"regularization", {r}}});
    EXPECT_LT(
        relative(matrix(without.at("contact_wrenches"), c.rows), matrix(plain.at("contact_wrenches"), c.rows)),
        kDynamics);
    ++compared;
  });
  EXPECT_GT(compared, 10);
}

TEST(Contacts, OperationalSpaceIsDynamicallyConsistent) {
  int compared = 0;
  for_each_case("operational_space", [&](Case& c) {
    const Values by_contact = c.random_activity(), active = c.by_row(by_contact);
    const Values compliance = c.random(c.rows, 1e-2, 1);
    const Matrix J = c.contact_jacobian(), H = c.inertia();
    // The columns of the inverse from the dense system: a unit acceleration at one row at a time.
    Matrix expected(c.rows, c.rows), inverse(c.size(), c.rows);
    for (int k = 0; k < c.rows; ++k) {
      if (active[static_cast<std::size_t>(k)] == 0) continue;
      Vector unit(c.rows);
      unit(k) = 1;
      const auto x = reference::solve_contacts(H, J, Vector(c.size()), unit, active, compliance, kDigits);
      if (!x) return;
      inverse.set_block(0, k, x->head(c.size()));
      expected.set_block(0, k, x->tail(c.rows));
    }
    const auto results = c.run_plain("operational_space", {{"active", by_contact}, {"compliance", compliance}});
    EXPECT_LT(relative(matrix(results.at("inertia"), c.rows), expected), kDynamics);
    EXPECT_LT(relative(matrix(results.at("inverse"), c.size()), inverse), kDynamics);
    const Matrix projector = Matrix::identity(c.size()) - inverse * J;
    EXPECT_LT(relative(matrix(results.at("projector"), c.size()), projector), kDynamics);
    ++compared;
  });
  EXPECT_GT(compared, 30);
}

// The results of a function, one after another.
Vector joined(const symbolic::Program& program, const symbolic::Arrays<double>& results) {
  Values all;
  for (const symbolic::OutputArray& output : program.outputs)
    all.insert(all.end(), results.at(output.name).begin(), results.at(output.name).end());
  return matrix(all, static_cast<int>(all.size()));
}

// In double, with all formulations and passes, against differences of the dense system.
TEST(Contacts, DerivativesAreThoseOfTheDenseSystem) {
  int compared = 0, floating = 0;
  reference::Checks checks;
  for_each_case(
      "constrained_forward_dynamics_derivatives",
      [&](Case& c) {
        const Values by_contact = c.random_activity(),
                     restitution = c.random(static_cast<int>(by_contact.size()), 0, 1);
        const Values tau = c.random(c.robot_tree.dof(), -20, 20), wanted = c.random(c.rows, -5, 5);
        const reference::ContactState state{
            {c.motion, c.loads(), matrix(tau, c.robot_tree.dof())},
            matrix(wanted, c.rows),
            matrix(c.by_row(restitution), c.rows),
            c.by_row(by_contact),
            c.random(c.rows, 0.1, 1)};
        if (!constrained_accelerations(c.tables->robot(), state, kDigits)) return;
        const reflection::Robot tables = c.tables->robot();
        const reference::Case at(tables, c.sample, static_cast<int>(c.seed));
        std::mt19937_64 engine(c.seed);
        const auto blocks_of = [&](const std::string& name, const symbolic::Arrays<double>& results, auto value) {
          const auto& programs = c.robot->programs();
          return reference::ContactBlocks(at, name, joined(programs.at(name), results), state, value, checks);
        };
        const std::string name = "constrained_forward_dynamics_derivatives";
        reference::ContactBlocks blocks = blocks_of(
            name,
            c.run(
                name, {{"tau", tau},
                       {"contact_acceleration", wanted},
                       {"active", by_contact},
                       {"compliance", state.compliance}}),
            reference::constrained_accelerations);
        compare_blocks_of_forward_dynamics(blocks, at, engine);
        reference::ContactBlocks of_impact = blocks_of(
            "impact_derivatives",
            c.run_plain(
                "impact_derivatives",
                {{"restitution", restitution}, {"active", by_contact}, {"compliance", state.compliance}}),
            reference::velocities_after_impact);
        compare_blocks_of_impact(of_impact, at, engine);
        ++compared;
        floating += c.floating() ? 1 : 0;
      },
      5);
  EXPECT_EQ(checks.failures(), 0) << checks.failure_report();
  EXPECT_GT(compared, 8);
  EXPECT_GT(floating, 2);
}

// A single contact that is singular: the robot has one joint, and its tip cannot move along the link.
TEST(Contacts, OpenOnesAreRegularWhateverTheyAre) {
  const KinematicTree tree = random_robot(3, {.min_joints = 1, .max_joints = 1});
  ASSERT_FALSE(tree.floating_base);
  model::DesiredTransforms desired;
  desired.contacts = {{*tree.find_frame("fr_" + tree.links[1].name)}};
  const InterpretedRobot robot(tree, desired, all_steps(), {}, {}, {"contacts", "forward_dynamics"});
  const auto run = [&](double active, double compliance) {
    return robot.run(
        "constrained_forward_dynamics", {},
        {{"q", {0.3}},
         {"qd", {0.2}},
         {"tau", {1.5}},
         {"contact_acceleration", {0, 0, 0}},
         {"active", {active}},
         {"compliance", {compliance, compliance, compliance}}});
  };
  const auto free = robot.run("forward_dynamics", {}, {{"q", {0.3}}, {"qd", {0.2}}, {"tau", {1.5}}}).at("qdd");
  const auto open = run(0, 0);
  EXPECT_NEAR(open.at("qdd").front(), free.front(), kDynamics * (1 + std::abs(free.front())));
  EXPECT_EQ(open.at("contact_wrenches"), Values(3));
  const auto pushed = run(1, 1e-3);
  for (const double f : pushed.at("contact_wrenches")) EXPECT_TRUE(std::isfinite(f));
}

// Two frames coincide: without compliance their rows are redundant; with compliance they share the load.
TEST(Contacts, RedundantOnesShareTheLoad) {
  KinematicTree tree;
  for (std::uint64_t seed = 0; !tree.floating_base; ++seed)
    tree = random_robot(seed, {.min_joints = 4, .max_joints = 6, .odd_documents = false});
  const int last = static_cast<int>(tree.links.size()) - 1;
  model::DesiredTransforms desired;
  for (const char* name : {"left_tip", "right_tip"}) {
    model::UserFrame frame;
    frame.name = name;
    frame.link = last;
    frame.placement.translation[0] = model::Quantity(0.4);
    tree.user_frames.push_back(frame);
    desired.contacts.push_back({*tree.find_frame(name)});
  }
  const InterpretedRobot robot(tree, desired, all_steps(), {}, {}, {"contacts"});
  const Values zeros(static_cast<std::size_t>(tree.dof()));
  const auto wrenches = [&](const Values& active, double compliance) {
    return robot
        .run(
            "constrained_forward_dynamics", {},
            {{"q", zeros},
             {"qd", zeros},
             {"tau", zeros},
             {"base_velocity", Values(6)},
             {"contact_acceleration", Values(6)},
             {"active", active},
             {"compliance", Values(6, compliance)}})
        .at("contact_wrenches");
  };
  const Values alone = wrenches({1, 0}, 1e-9), both = wrenches({1, 1}, 1e-9);
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(alone[k]));
  ASSERT_GT(largest, 1.0);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(both[k], both[3 + k], 1e-5 * largest);
    EXPECT_NEAR(both[k] + both[3 + k], alone[k], 1e-5 * largest);
  }
}

// Legs on a fixed base: no coordinate moves two feet.
TEST(Contacts, ThatShareNoCoordinateHaveLiteralZeros) {
  const KinematicTree tree = random_robot(11, {.min_joints = 6, .max_joints = 6, .shape = Shape::star});
  model::DesiredTransforms desired;
  for (const model::Link& link : tree.links)
    if (link.parent_joint >= 0 && link.child_joints.empty())
      desired.contacts.push_back({*tree.find_frame("fr_" + link.name)});
  ASSERT_GT(desired.contacts.size(), 2U);
  const InterpretedRobot robot(tree, desired, {}, {}, {}, {"contacts"});
  const symbolic::Program& program = robot.program("inverse_contact_inertia");
  const symbolic::OutputArray& W = program.outputs.front();
  for (int r = 0; r < W.rows; ++r)
    for (int c = 0; c < W.columns; ++c) {
      const symbolic::Operand& o = W.values[static_cast<std::size_t>(r + c * W.rows)];
      const bool is_zero = is_constant(o) && program.constants[static_cast<std::size_t>(o.index)].value() == 0;
      EXPECT_TRUE(r / 3 == c / 3 || tree.floating_base || is_zero) << r << " " << c;
    }
}

TEST(Contacts, CentroidalBiasIsTheRateOfMomentumWithoutAccelerations) {
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    Case c(static_cast<std::uint64_t>(i), {"centroidal", "centroidal_bias"});
    if (!c.robot->has("centroidal_momentum_bias")) continue;
    reference::Motion<Real> still = c.motion;
    const reference::Loads<Real> none{Vector(3), {}, false};
    const Vector wrench = reference::bias_forces(c.tables->robot(), still, none).base_wrench;
    const Values com = c.run_plain("center_of_mass").at("com");
    const Vector moment = wrench.head(3) - reference::cross(matrix(com, 3), wrench.tail(3));
    const Vector expected = reference::stacked(moment, wrench.tail(3));
    EXPECT_LT(relative(matrix(c.run_plain("centroidal_momentum_bias").at("bias"), 6), expected), kDynamics) << i;
    ++compared;
  }
  EXPECT_GT(compared, 40);
}

TEST(JacobiansWithBase, AndBiasesAreThoseOfTheFrames) {
  int compared = 0;
  for (int i = 0; i < 120; ++i) {
    Case c(static_cast<std::uint64_t>(i), {"jacobians_with_base"});
    for (const model::FramePair& pair : c.desired.jacobians) {
      const std::string name = "with_base_" + pair.left.name + "_J_" + pair.right.name;
      const bool is_of_base = c.robot_tree.link_of(pair.left) == 0;
      ASSERT_EQ(c.robot->has(name), is_of_base);
      if (!is_of_base) continue;
      const int left = frame_index(c.robot_tree, pair.left), base = 0;
      const Matrix R = reference::rotation_of(reference::transform(c.tables->robot(), c.motion.q, left, base));
      Matrix both(6, 6);
      both.set_block(0, 0, R);
      both.set_block(3, 3, R);
      EXPECT_LT(relative(matrix(c.run_plain(name).at("J"), 6), both * c.jacobian(pair.right)), kKinematics) << i;
      const std::string bias = "with_base_" + pair.left.name + "_bias_" + pair.right.name;
      EXPECT_LT(relative(matrix(c.run_plain(bias).at("a"), 6), both * c.bias(pair.right)), kKinematics) << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 30);
}

}  // namespace
}  // namespace robcogen::numeric::contacts_test
