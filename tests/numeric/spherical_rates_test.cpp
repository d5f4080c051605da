// Derivatives and rates of robots with spherical joints, compared with differences in long double of the functions
// themselves. The child is rotated about its own axes: q (1, t / 2) for a small t.
#include <gtest/gtest.h>

#include <cmath>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/kinematics/kinematics.h"
#include "at.h"
#include "interpreted_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "spherical_robot.h"

namespace robcogen::numeric::spherical_rates_test {
namespace {

using model::KinematicTree;
using Real = long double;
using Values = std::vector<Real>;
using Arrays = symbolic::Arrays<Real>;

constexpr int kRobots = 12;
constexpr double kSame = 1e-9;  // for a fourth-order difference with step 1e-3, of functions with rates up to ten
constexpr Real kStep = 1e-3L;

// Every other robot has rotors and other drives on the remaining joints.
KinematicTree robot_of(int number) {
  for (auto seed = static_cast<std::uint64_t>(number);; seed += kRobots) {
    const RobotOptions options = {.min_joints = 1, .max_joints = 5, .odd_documents = false};
    KinematicTree robot = random_robot(seed, options);
    if (number % 2 == 1) robot = with_random_drives(std::move(robot), seed);
    robot = with_spherical_joints(robot, seed);
    if (!robot.inertia_defects.is_singular() && !robot.spherical_joints().empty()) return robot;
  }
}

// Returns the positions after a motion by `turn`, which has one element per velocity.
Values moved(const KinematicTree& robot, const Values& q, const Values& turn) {
  Values result = q;
  const std::vector<int> elements = robot.position_elements();
  for (std::size_t j = 0; j < elements.size(); ++j)
    if (robot.joints[j].spherical.empty()) result[at(elements[j])] += turn[j];
  for (const int first : robot.spherical_joints()) {
    const Real* t = &turn[at(first)];
    const Real angle = std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]) / 2;
    const Real c = std::cos(angle), s = (angle == 0 ? 1 : std::sin(angle) / angle) / 2;
    const Real x = s * t[0], y = s * t[1], z = s * t[2];
    const Real* p = &q[at(elements[at(first)] - 1)];
    Real* r = &result[at(elements[at(first)] - 1)];
    r[0] = p[0] * c - p[1] * x - p[2] * y - p[3] * z;
    r[1] = p[0] * x + p[1] * c + p[2] * z - p[3] * y;
    r[2] = p[0] * y - p[1] * z + p[2] * c + p[3] * x;
    r[3] = p[0] * z + p[1] * y - p[2] * x + p[3] * c;
  }
  return result;
}

Values operator*(Real k, Values v) {
  for (Real& x : v) x *= k;
  return v;
}

Values operator+(Values a, const Values& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

// The derivative of f(step) at 0.
template <class F>
Values difference(const F& f) {
  const Values a = f(kStep), b = f(-kStep), c = f(2 * kStep), d = f(-2 * kStep);
  Values result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * kStep);
  return result;
}

void expect_same(const Values& found, const Values& wanted, const std::string& what, double tolerance = kSame) {
  ASSERT_EQ(found.size(), wanted.size()) << what;
  Real largest = 1, error = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    largest = std::max(largest, std::abs(wanted[i]));
    error = std::max(error, std::abs(found[i] - wanted[i]));
  }
  EXPECT_LT(error / largest, tolerance) << what;
}

class Subject {
 public:
  explicit Subject(int number)
      : tree(robot_of(number)),
        robot_(tree, random_desired(static_cast<std::uint64_t>(number), tree), number % 3 == 0 ? all_steps() : none_) {
    std::mt19937_64 engine(static_cast<std::uint64_t>(number));
    const auto some = [&](int size) {
      const reference::Vector<double> v = reference::uniform_vector(engine, size, 1.5);
      return Values(v.values().begin(), v.values().end());
    };
    const int n = tree.dof();
    const Values still(at(tree.position_count()), 0);
    Values start = still;
    for (const int first : tree.spherical_joints()) start[at(tree.position_elements()[at(first)] - 1)] = 1;
    state = {
        {"q", moved(tree, start, some(n))},
        {"qd", some(n)},
        {"qdd", some(n)},
        {"tau", some(n)},
        {"gravity", some(3)},
        {"weights", some(n + (tree.floating_base ? 6 : 0))}};
    state["base_velocity"] = some(6);
    state["base_acceleration"] = some(6);
  }

  // Runs a function with gravity as argument. The base comes first, if it floats.
  Values run(const std::string& function, const Arrays& in, const std::string& output, const std::string& base = "")
      const {
    const auto& programs = robot_.programs();
    const std::string with_gravity = function + (tree.floating_base ? "" : "_gravity");
    const symbolic::Program& program = programs.at(programs.contains(with_gravity) ? with_gravity : function);
    Arrays inputs;
    for (const symbolic::InputArray& array : program.inputs) inputs[array.name] = in.at(array.name);
    const Arrays results = symbolic::interpret<Real>(program, inputs);
    Values values;
    if (tree.floating_base && !base.empty()) values = results.at(base);
    const Values& last = results.at(output);
    values.insert(values.end(), last.begin(), last.end());
    return values;
  }

  // Returns the state with one of its arrays moved along a direction.
  Arrays changed(const std::string& array, const Values& along) const {
    Arrays result = state;
    result[array] = array == "q" ? moved(tree, state.at("q"), along) : state.at(array) + along;
    return result;
  }

  // Returns the derivative with respect to an array of the state, one column per velocity.
  Values columns(const std::string& function, const std::string& array, const char* output, const char* base) const {
    Values result;
    for (int k = 0; k < tree.dof(); ++k) {
      Values axis(at(tree.dof()), 0);
      axis[at(k)] = 1;
      const Values column =
          difference([&](Real step) { return run(function, changed(array, step * axis), output, base); });
      result.insert(result.end(), column.begin(), column.end());
    }
    return result;
  }

  // Returns the rate of f along the state's own motion.
  template <class F>
  Values rate(const F& f) const {
    return difference([&](Real step) {
      const Values& qdd = state.at("qdd");
      const Values turn = step * state.at("qd") + (step * step / 2) * qdd;
      Arrays there = changed("q", turn);
      there["qd"] = state.at("qd") + step * qdd;
      return f(there);
    });
  }

  const KinematicTree tree;
  Arrays state;

  const std::map<std::string, symbolic::Program>& programs() const { return robot_.programs(); }

 private:
  inline static const std::vector<std::string> none_;
  InterpretedRobot robot_;
};

// Returns the coordinates of a chain, given the name `left_Jd_qd_right`.
std::vector<int> columns_of(const KinematicTree& tree, const std::string& name) {
  const std::string letters = "_Jd_qd_";
  const std::size_t place = name.find(letters);
  const auto left = tree.find_frame(name.substr(0, place)),
             right = tree.find_frame(name.substr(place + letters.size()));
  return algorithm::chain_coordinates(tree, {left.value(), right.value()});
}

class SphericalRates : public testing::TestWithParam<int> {};

TEST_P(SphericalRates, DerivativesAreThoseOfTheForces) {
  const Subject s(GetParam());
  const std::string forces = s.tree.floating_base ? "inverse_dynamics_fully_actuated" : "inverse_dynamics";
  for (const std::string by : {"q", "qd", "qdd"}) {
    const Values found = s.run(forces + "_derivatives", s.state, "d_" + by);
    expect_same(found, s.columns(forces, by, "tau", "base_wrench"), "inverse dynamics by " + by);
    // The gradient is weights times columns.
    const Values gradient = s.run("inverse_dynamics_gradient", s.state, "d_" + by);
    const Values& weights = s.state.at("weights");
    Values product(at(s.tree.dof()), 0);
    for (std::size_t i = 0; i < found.size(); ++i)
      product[i / weights.size()] += weights[i % weights.size()] * found[i];
    expect_same(gradient, product, "gradient by " + by);
  }
  expect_same(
      s.run("gravity_forces_derivative", s.state, "d_q"), s.columns("gravity_forces", "q", "tau", "base_wrench"),
      "gravity forces");
  for (const std::string by : {"q", "qd", "tau"}) {
    const Values found = s.run("forward_dynamics_derivatives", s.state, "d_" + by);
    const Values wanted = s.columns("forward_dynamics", by, "qdd", "base_acceleration");
    expect_same(found, wanted, "forward dynamics by " + by);
  }
}

// Rows belong to the first input, columns to the second; the order matters because rotations about two axes do not
// commute.
TEST_P(SphericalRates, SecondDerivativesAreThoseOfTheGradient) {
  constexpr double kSameTwice = 1e-7;  // friction is smoothed over small velocities
  const Subject s(GetParam());
  if (!algorithm::is_available(s.tree, "inverse_dynamics_second_derivatives")) return;
  const auto wanted = [&](const std::string& of, const std::string& by) {
    return s.columns("inverse_dynamics_gradient", by, ("d_" + of).c_str(), "");
  };
  for (const auto& [of, by] : {std::pair("q", "q"), {"qd", "q"}, {"qdd", "q"}, {"qd", "qd"}}) {
    const std::string block = std::string("d_") + of + "_" + by;
    expect_same(s.run("inverse_dynamics_second_derivatives", s.state, block), wanted(of, by), block, kSameTwice);
  }
}

TEST_P(SphericalRates, CoriolisMatrixIsHalfTheRateOfInertia) {
  const Subject s(GetParam());
  const Values C = s.run("coriolis_matrix", s.state, "C");
  const Values rate = s.rate([&](const Arrays& there) { return s.run("joint_space_inertia", there, "H"); });
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(C.size()))));
  Values sum(C.size());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) sum[i + j * n] = C[i + j * n] + C[j + i * n];
  expect_same(sum, rate, "C + C'");
}

// dE/dt is the power of the joint forces minus that of the passive forces.
TEST_P(SphericalRates, EnergyIsBalanced) {
  const Subject s(GetParam());
  if (s.tree.floating_base) return;
  const Values rate = s.rate(
      [&](const Arrays& there) { return s.run("kinetic_energy", there, "T") + s.run("potential_energy", there, "V"); });
  const Values tau = s.run("inverse_dynamics", s.state, "tau"), passive = s.run("passive_forces", s.state, "tau");
  Real power = 0;
  for (std::size_t j = 0; j < tau.size(); ++j) power += (tau[j] - passive[j]) * s.state.at("qd")[j];
  expect_same(rate, {power}, "power");
}

TEST_P(SphericalRates, FramesMoveAsTheirPosesDo) {
  const Subject s(GetParam());
  for (const auto& function : s.programs()) {
    const std::string& name = function.first;
    const auto& program = function.second;
    const symbolic::OutputArray& result = program.outputs.front();
    const auto of_frames = [&](const char* letter) {
      std::string other = name;
      const std::string own = result.role == symbolic::Role::jacobian_derivative ? "_Jd_" : "_A_";
      return other.replace(other.find(own), own.size(), letter);
    };
    if (result.role == symbolic::Role::jacobian_derivative)
      expect_same(
          s.run(name, s.state, "Jd"), s.rate([&](const Arrays& there) { return s.run(of_frames("_J_"), there, "J"); }),
          name);
    if (result.role == symbolic::Role::frame_acceleration)
      expect_same(
          s.run(name, s.state, "A"), s.rate([&](const Arrays& there) { return s.run(of_frames("_V_"), there, "V"); }),
          name);
    if (result.role != symbolic::Role::frame_bias_acceleration) continue;
    std::string derivative = name;
    derivative.replace(derivative.find("_Jd_qd_"), 7, "_Jd_");
    const Values Jd = s.run(derivative, s.state, "Jd");
    const std::vector<int> columns = columns_of(s.tree, name);
    Values product(6, 0);
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (std::size_t i = 0; i < 6; ++i) product[i] += Jd[i + 6 * k] * s.state.at("qd")[at(columns[k])];
    expect_same(s.run(name, s.state, "a"), product, name);
  }
}

INSTANTIATE_TEST_SUITE_P(Robot, SphericalRates, testing::Range(0, kRobots));

}  // namespace
}  // namespace robcogen::numeric::spherical_rates_test
