// Identities that the derivatives of the dynamics satisfy for every robot: relations to functions that share no
// formulas with them, and differences of the reference along each coordinate.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/dynamics/dynamics.h"
#include "coupled_robot.h"
#include "interpreted_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "robcogen/reference/check_derivatives.h"
#include "spherical_robot.h"
#include "symbolic/interpret.h"

namespace robcogen::numeric::derivative_identities_test {
namespace {

using algorithm::Loads;
using symbolic::Program;
using Values = std::vector<long double>;
using State = symbolic::Arrays<long double>;

constexpr std::uint64_t kRobots = 120;
// The identities are exact: only rounding of long double remains.
constexpr long double kNear = 1e-12L;

// Robots with all joint types. Some have rotors and other drives, some coupled joints, some spherical joints.
model::KinematicTree robot_of(std::uint64_t seed) {
  model::KinematicTree robot = random_robot(seed, {.max_joints = 10});
  if (seed % 3 == 0) robot = with_random_drives(std::move(robot), seed);
  if (seed % 4 == 1) return coupled(robot, seed).robot;
  return seed % 4 == 2 ? with_spherical_joints(robot, seed, seed % 3 == 0) : robot;
}

std::string message(std::uint64_t seed, const std::string& what) {
  return "seed " + std::to_string(seed) + ": " + what;
}

// Draws values for all inputs of the program; quaternions have unit length.
void draw(const Program& program, std::mt19937_64& engine, State& state) {
  for (const symbolic::InputArray& array : program.inputs) {
    Values& values = state[array.name];
    if (!values.empty()) continue;
    for (std::size_t k = 0; k < array.elements.size(); ++k)
      values.push_back(static_cast<long double>(engine() >> 11) * 0x1p-51L - 2);
    for (const int first : array.quaternions) {
      const auto begin = values.begin() + first;
      const long double norm = std::sqrt(std::inner_product(begin, begin + 4, begin, 0.0L));
      std::for_each(begin, begin + 4, [&](long double& e) { e /= norm; });
    }
  }
}

State random_state(const std::vector<const Program*>& programs, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  State state;
  for (const Program* program : programs) draw(*program, engine, state);
  return state;
}

State results(const Program& program, const State& state) {
  State inputs;
  for (const symbolic::InputArray& array : program.inputs) inputs[array.name] = state.at(array.name);
  return symbolic::interpret(program, inputs);
}

// Returns the values of the base, if it floats, followed by those of the joints.
Values stacked(const State& results, const std::string& of_base, const std::string& of_joints) {
  const auto base = results.find(of_base);
  Values all = base == results.end() ? Values() : base->second;
  all.insert(all.end(), results.at(of_joints).begin(), results.at(of_joints).end());
  return all;
}

Values sum(long double a, const Values& x, long double b, const Values& y) {
  EXPECT_EQ(x.size(), y.size());
  Values result(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) result[k] = a * x[k] + b * y[k];
  return result;
}

// Matrices are column-major.
Values product(const Values& matrix, const Values& columns, std::size_t inner) {
  if (inner == 0 || columns.empty()) return {};
  const std::size_t rows = matrix.size() / inner;
  Values result(rows * (columns.size() / inner));
  for (std::size_t c = 0; c < columns.size() / inner; ++c)
    for (std::size_t k = 0; k < inner; ++k)
      for (std::size_t r = 0; r < rows; ++r) result[r + c * rows] += matrix[r + k * rows] * columns[k + c * inner];
  return result;
}

long double largest(const Values& values) {
  long double result = 1;
  for (const long double x : values) result = std::max(result, std::abs(x));
  return result;
}

// `size` is the size of the terms that each element sums.
void expect_same(const Values& found, const Values& expected, long double size, const std::string& what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t k = 0; k < found.size(); ++k)
    ASSERT_LE(std::abs(found[k] - expected[k]), kNear * size)
        << what << ", element " << k << ": " << static_cast<double>(found[k]) << ", not "
        << static_cast<double>(expected[k]);
}

void expect_same(const Values& found, const Values& expected, const std::string& what) {
  expect_same(found, expected, largest(expected), what);
}

void set_zero(State& state, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto place = state.find(name); place != state.end())
      std::fill(place->second.begin(), place->second.end(), 0.0L);
}

void negate_velocities(State& state) {
  for (const char* name : {"qd", "base_velocity"})
    if (const auto place = state.find(name); place != state.end())
      for (long double& x : place->second) x = -x;
}

Values forces(const Program& newton_euler, const State& state) {
  return stacked(results(newton_euler, state), "base_wrench", "tau");
}

// The derivative with respect to accelerations is the joint-space inertia matrix.
TEST(DerivativeIdentities, ByAccelerationsTheyAreTheInertiaMatrix) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = robot_of(seed);
    const Program d = algorithm::inverse_dynamics_derivatives(robot, "d", Loads::gravity_and_external);
    const Program inertia = algorithm::joint_space_inertia(robot, "H");
    const State state = random_state({&d}, seed);
    expect_same(
        stacked(results(d, state), "d_base_acceleration", "d_qdd"), results(inertia, state).at("H"),
        message(seed, "d_qdd"));
  }
}

// The forces that velocities cause, without the odd terms such as damping, are a quadratic form Q: its derivative times
// the velocities is 2 Q (Euler).
TEST(DerivativeIdentities, ByVelocitiesTheyAreThoseOfAQuadraticForm) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = robot_of(seed);
    const Program d = algorithm::inverse_dynamics_derivatives(robot, "d", Loads::gravity_and_external);
    const Program plain = algorithm::newton_euler(robot, "f", Loads::gravity_and_external);
    const State state = random_state({&d}, seed);
    State back = state, rest = state;
    negate_velocities(back);
    set_zero(rest, {"qd", "base_velocity"});
    const Values there = forces(plain, state);
    const Values even = sum(0.5L, there, 0.5L, forces(plain, back));
    const Values quadratic = sum(1, even, -1, forces(plain, rest));
    const Values odd_columns =
        sum(0.5L, stacked(results(d, state), "d_base_velocity", "d_qd"), -0.5L,
            stacked(results(d, back), "d_base_velocity", "d_qd"));
    const Values velocities = stacked(state, "base_velocity", "qd");
    const Values along = product(odd_columns, velocities, velocities.size());
    expect_same(along, sum(2, quadratic, 0, quadratic), largest(there), message(seed, "d_qd qd"));
  }
}

// At rest the derivatives with respect to positions are second derivatives of the potential energy of gravity and
// springs: they are symmetric, and without springs they equal those of the gravity forces. Symmetry does not hold for
// spherical joints, because rotations about their axes do not commute.
TEST(DerivativeIdentities, ByPositionsAtRestTheyAreSymmetric) {
  int robots = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = robot_of(seed);
    const Program d = algorithm::inverse_dynamics_derivatives(robot, "d", Loads::gravity);
    const Program of_gravity = algorithm::gravity_forces_derivative(robot, "g", Loads::gravity);
    State state = random_state({&d}, seed);
    set_zero(state, {"qd", "qdd", "base_velocity", "base_acceleration"});
    const State found = results(d, state);
    const Values& columns = found.at("d_q");
    const std::size_t n = static_cast<std::size_t>(robot.dof()), base = robot.floating_base ? 6 : 0, rows = base + n;
    if (seed % 3 != 0) {
      const State expected = results(of_gravity, state);
      expect_same(columns, expected.at("d_q"), message(seed, "d_q at rest"));
      if (base > 0)
        expect_same(found.at("d_base_rotation"), expected.at("d_base_rotation"), message(seed, "d_base_rotation"));
    }
    if (!robot.spherical_joints().empty()) continue;
    ++robots;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        ASSERT_LE(std::abs(columns[base + i + j * rows] - columns[base + j + i * rows]), kNear * largest(columns))
            << message(seed, "d_q at rest");
  }
  EXPECT_GT(robots, 60);
}

// With a(x) the accelerations of forward dynamics: H da/dx + df/dx = 0, where f are the forces of inverse dynamics at
// these accelerations; and H times the derivatives with respect to tau is the identity.
TEST(DerivativeIdentities, OfForwardDynamicsThroughTheInertiaMatrix) {
  int robots = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = robot_of(seed);
    if (!algorithm::is_available(robot, "forward_dynamics_derivatives")) continue;
    ++robots;
    const Loads loads = seed % 2 == 0 ? Loads::gravity : Loads::gravity_and_external;
    const Program forward = algorithm::forward_dynamics_derivatives(robot, "a", loads);
    const Program inverse = algorithm::inverse_dynamics_derivatives(robot, "f", loads);
    State state = random_state({&forward}, seed);
    const State a = results(forward, state);
    state["qdd"] = a.at("qdd");
    if (robot.floating_base) state["base_acceleration"] = a.at("base_acceleration");
    const State f = results(inverse, state);
    const Values H = results(algorithm::joint_space_inertia(robot, "H"), state).at("H");
    const std::size_t n = static_cast<std::size_t>(robot.dof()), base = robot.floating_base ? 6 : 0;
    for (const std::string block : {"d_q", "d_qd", "d_base_rotation", "d_base_velocity"}) {
      if (!a.contains(block)) continue;
      const Values opposite = product(H, a.at(block), base + n);
      const long double size = largest(H) * largest(a.at(block));
      expect_same(opposite, sum(-1, f.at(block), 0, f.at(block)), size, message(seed, block));
    }
    Values unit((base + n) * n);
    for (std::size_t j = 0; j < n; ++j) unit[base + j + j * (base + n)] = 1;
    const Values& by_tau = a.at("d_tau");
    expect_same(product(H, by_tau, base + n), unit, largest(H) * largest(by_tau), message(seed, "d_tau"));
  }
  EXPECT_GT(robots, 60);
}

// For a free base: its acceleration leaves no wrench, H_bb da + dw = 0, and adds H_jb da to the forces.
TEST(DerivativeIdentities, OfAFreeBaseThroughTheInertiaMatrix) {
  int robots = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = robot_of(seed);
    if (!robot.floating_base || robot.inertia_defects.locked_base) continue;
    ++robots;
    const Program of_free_base =
        algorithm::unactuated_base_inverse_dynamics_derivatives(robot, "d", Loads::gravity_and_external);
    const Program given = algorithm::inverse_dynamics_derivatives(robot, "f", Loads::gravity_and_external);
    State state = random_state({&of_free_base}, seed);
    const State found = results(of_free_base, state);
    state["base_acceleration"] = found.at("base_acceleration");
    const State f = results(given, state);
    const std::size_t rows = 6 + static_cast<std::size_t>(robot.dof());
    for (const std::string block : {"d_q", "d_qd", "d_qdd", "d_base_rotation", "d_base_velocity"}) {
      Values expected = f.at(block), actual = found.at(block);
      for (std::size_t c = 0; c < actual.size() / rows; ++c) {
        const Values da(
            actual.begin() + static_cast<std::ptrdiff_t>(c * rows),
            actual.begin() + static_cast<std::ptrdiff_t>(c * rows) + 6);
        const Values added = product(f.at("d_base_acceleration"), da, 6);
        for (std::size_t r = 0; r < rows; ++r) expected[r + c * rows] += added[r];
        std::fill_n(actual.begin() + static_cast<std::ptrdiff_t>(c * rows), 6, 0.0L);
      }
      const long double size = largest(f.at("d_base_acceleration")) * largest(found.at(block));
      expect_same(actual, expected, size, message(seed, block));
    }
  }
  EXPECT_GT(robots, 20);
}

// In base coordinates a rotation of the base rotates gravity the other way. Forces are linear in gravity and in the
// base acceleration, and quadratic in the base velocity, so that differences with unit steps are exact.
void expect_base_columns(
    const Program& derivatives,
    const Program& plain,
    const std::string& of_base,
    std::uint64_t seed) {
  const std::string of_joints = of_base == "base_wrench" ? "tau" : "qdd";
  const State state = random_state({&derivatives}, seed), found = results(derivatives, state);
  const auto value = [&](const State& at) { return stacked(results(plain, at), of_base, of_joints); };
  const Values here = value(state);
  const auto expect_column = [&](const std::string& block, std::size_t k, const Values& expected) {
    const auto begin = found.at(block).begin() + static_cast<std::ptrdiff_t>(k * here.size());
    const Values column(begin, begin + static_cast<std::ptrdiff_t>(here.size()));
    expect_same(column, expected, 10 * largest(here), message(seed, block));
  };
  const Values& g = state.at("gravity");
  for (std::size_t k = 0; k < 3; ++k) {
    State turned = state;
    turned["gravity"][(k + 1) % 3] += g[(k + 2) % 3];  // g x e_k
    turned["gravity"][(k + 2) % 3] -= g[(k + 1) % 3];
    expect_column("d_base_rotation", k, sum(1, value(turned), -1, here));
  }
  for (std::size_t k = 0; k < 6; ++k) {
    State more = state, less = state;
    more["base_velocity"][k] += 1;
    less["base_velocity"][k] -= 1;
    expect_column("d_base_velocity", k, sum(0.5L, value(more), -0.5L, value(less)));
    if (of_base != "base_wrench") continue;
    State faster = state;
    faster["base_acceleration"][k] += 1;
    expect_column("d_base_acceleration", k, sum(1, value(faster), -1, here));
  }
}

TEST(DerivativeIdentities, ByTheBaseTheyAreWholeSteps) {
  int robots = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = robot_of(seed);
    if (!robot.floating_base) continue;
    ++robots;
    constexpr Loads kLoads = Loads::gravity_and_external;
    expect_base_columns(
        algorithm::inverse_dynamics_derivatives(robot, "d", kLoads), algorithm::newton_euler(robot, "f", kLoads),
        "base_wrench", seed);
    if (algorithm::is_available(robot, "forward_dynamics_derivatives"))
      expect_base_columns(
          algorithm::forward_dynamics_derivatives(robot, "d", kLoads),
          algorithm::forward_dynamics(robot, "f", kLoads, algorithm::ForwardDynamicsChoice()), "base_acceleration",
          seed);
  }
  EXPECT_GT(robots, 20);
}

// True if `joint` is `other` or carries it.
bool supports(const model::KinematicTree& robot, int joint, int other) {
  while (other >= 0 && other != joint) other = robot.parent_joint_of(other);
  return other == joint;
}

// Joints on different branches do not affect each other: these elements are literal zeros.
TEST(DerivativeIdentities, BetweenBranchesTheyAreLiteralZeros) {
  int zeros = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const model::KinematicTree robot = random_robot(seed, {.max_joints = 10});
    const Program d = algorithm::inverse_dynamics_derivatives(robot, "d", Loads::gravity_and_external);
    const int n = robot.dof(), base = robot.floating_base ? 6 : 0;
    for (const symbolic::OutputArray& output : d.outputs) {
      if (output.name != "d_q" && output.name != "d_qd" && output.name != "d_qdd") continue;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          if (supports(robot, i, j) || supports(robot, j, i)) continue;
          const symbolic::Operand& value = output.values[static_cast<std::size_t>(base + i + j * output.rows)];
          ++zeros;
          ASSERT_TRUE(symbolic::is_constant(value) && d.constants[static_cast<std::size_t>(value.index)].value() == 0)
              << message(seed, output.name) << ' ' << i << ' ' << j;
        }
    }
  }
  EXPECT_GT(zeros, 1000);
}

// Fourth-order differences of the reference, in long double, along one coordinate at a time.
struct ByReference {
  const reference::Case& c;
  const reference::Loads<reference::Real>& loads;
  std::uint64_t seed;

  using Real = reference::Real;
  using Vector = reference::Vector<Real>;

  template <class Value, class Change>
  void compare(
      const char* name,
      const reference::Matrix<double>& block,
      const Vector& tau,
      const Value& value,
      const Change& change) const {
    for (int k = 0; k < block.cols(); ++k) {
      Vector direction(block.cols());
      direction(k) = 1;
      const Vector expected = reference::difference([&](Real step) {
        reference::Situation there{c.motion, loads, tau};
        change(there, step * direction);
        return value(c.robot, there);
      });
      Real size = 1;
      for (int r = 0; r < block.rows(); ++r) size = std::max(size, std::abs(expected(r)));
      for (int r = 0; r < block.rows(); ++r)
        ASSERT_LE(std::abs(static_cast<Real>(block(r, k)) - expected(r)), 1e-9L * size)
            << message(seed, name) << " by " << k << ", row " << r;
    }
  }

  template <class Value>
  void compare_all(const reference::Derivatives& d, const Vector& tau, const Value& value) const {
    using reference::Situation;
    compare("d_q", d.q, tau, value, [&](Situation& s, const Vector& u) {
      s.motion.q = reference::moved(c.robot, s.motion.q, u);
    });
    compare("d_qd", d.qd, tau, value, [](Situation& s, const Vector& u) { s.motion.qd += u; });
    if (tau.rows() > 0)
      compare("d_tau", d.last, tau, value, [](Situation& s, const Vector& u) { s.tau += u; });
    else
      compare("d_qdd", d.last, tau, value, [](Situation& s, const Vector& u) { s.motion.qdd += u; });
    compare("d_base_rotation", d.base_rotation, tau, value, [](Situation& s, const Vector& u) {
      s.loads.gravity = reference::seen_from_turned_base(s.loads.gravity, u);
    });
    compare("d_base_velocity", d.base_velocity, tau, value, [](Situation& s, const Vector& u) {
      s.motion.base_velocity += u;
    });
    compare("d_base_acceleration", d.base_acceleration, tau, value, [](Situation& s, const Vector& u) {
      s.motion.base_acceleration += u;
    });
  }
};

TEST(DerivativeIdentities, AgreeWithTheReferenceAlongEveryCoordinate) {
  constexpr std::uint64_t kFew = 60;
  for (std::uint64_t seed = 0; seed < kFew; ++seed) {
    const model::KinematicTree tree = robot_of(seed);
    const InterpretedRobot robot(
        tree, {}, {}, {}, {}, {"inverse_dynamics_derivatives", "forward_dynamics_derivatives"});
    const reflection::Robot tables = robot.tables();
    std::mt19937_64 engine(seed);
    reference::Sample sample;
    const reference::AtLoops at_loops = reference::draw(engine, tables, sample);
    const reference::Case c(at_loops.robot(), sample, 0, &at_loops);
    const reference::Overload o = reference::overloads(sample).back();
    ASSERT_TRUE(o.arguments.gravity != nullptr && o.arguments.external != nullptr);
    const ByReference by{c, o.loads, seed};
    by.compare_all(
        robot.inverse_dynamics_fully_actuated_derivatives(sample.motion, o.arguments), {},
        [&](const reference::Robot& r, const reference::Situation& s) {
          return reference::cut(c.floating, reference::generalized_forces(r, s.motion, s.loads));
        });
    if (!robot.programs().contains("forward_dynamics_derivatives")) continue;
    const reference::Vector<reference::Real> tau = reference::inverse_dynamics(c.robot, c.motion, o.loads).tau;
    by.compare_all(
        robot.forward_dynamics_derivatives(sample.motion, tau.template cast<double>(), o.arguments), tau,
        [&](const reference::Robot& r, const reference::Situation& s) {
          const auto a = reference::forward_dynamics(r, s.motion, s.tau, s.loads);
          return reference::coordinates(c.floating, a.base_acceleration, a.qdd);
        });
  }
}

}  // namespace
}  // namespace robcogen::numeric::derivative_identities_test
