// P7: a parametric robot with given parameter values behaves as the constant robot with these values.
#include <gtest/gtest.h>

#include "interpreted_robot.h"
#include "pass/split_parameters.h"
#include "random_robot.h"
#include "symbolic/cost.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"
#include "volume.h"

namespace robcogen::numeric::parameters_test {
namespace {

using model::KinematicTree;
using model::ParameterKind;
using model::Quantity;
using reference::Real;
using reference::Sample;
using reference::Vector;

// Folded constants are rounded in another order than parameters; both programs round.
constexpr Real kSame = 1e-12L;

struct Parametric {
  KinematicTree robot;
  std::vector<double> values;  // with these values it equals the robot that it was made from
};

// Applies f(quantity, kind) to every quantity of a robot.
template <class Function>
void for_each_quantity(KinematicTree& robot, const Function& f) {
  const auto placement = [&](model::Placement& p) {
    for (Quantity& q : p.translation) f(q, ParameterKind::length);
    for (Quantity& q : p.rotation) f(q, ParameterKind::angle);
  };
  for (model::Joint& joint : robot.joints) placement(joint.placement);
  for (model::UserFrame& frame : robot.user_frames) placement(frame.placement);
  for (model::Link& link : robot.links) {
    if (!link.inertia) continue;
    model::Inertia& I = *link.inertia;
    for (Quantity* q : {&I.mass, &I.com[0], &I.com[1], &I.com[2], &I.ixx, &I.iyy, &I.izz, &I.ixy, &I.ixz, &I.iyz})
      f(*q, ParameterKind::inertial);
    if (I.reference) placement(*I.reference);
  }
}

// Turns some of the numbers into parameters, alone or in expressions. Some of the lengths and angles are parameters of
// both interfaces.
Parametric parametric(const KinematicTree& constant, std::uint64_t seed) {
  Parametric result{constant, {}};
  std::mt19937_64 engine(seed);
  for_each_quantity(result.robot, [&](Quantity& q, ParameterKind kind) {
    const int choice = static_cast<int>(engine() % 10);
    if (choice >= 4) return;
    const double value = model::evaluate(q);
    const int index = static_cast<int>(result.values.size());
    const Quantity p = Quantity::parameter(index);
    switch (choice) {
      case 0:
        q = p;
        break;
      case 1:
        q = -p;
        break;
      case 2:
        q = Quantity(2.0) * p;
        break;
      default:
        q = p + Quantity(0.25);
        break;
    }
    const double inverse[] = {value, -value, value / 2, value - 0.25};
    result.robot.parameters.push_back({"p" + std::to_string(index), kind, {}, {}});
    result.robot.parameters.back().is_in_masses_too = kind != ParameterKind::inertial && engine() % 3 == 0;
    result.values.push_back(inverse[choice]);
  });
  return result;
}

// Returns the robot with the parameters replaced by their values.
KinematicTree constant_of(const Parametric& p, const std::vector<double>& values) {
  KinematicTree robot = p.robot;
  for_each_quantity(robot, [&](Quantity& q, ParameterKind) { q = Quantity(model::evaluate(q, values)); });
  robot.parameters.clear();
  return robot;
}

// Returns an empty string if both robots agree with the reference and with each other.
std::string difference(const Parametric& p, const std::vector<double>& values, std::uint64_t seed) {
  const KinematicTree constant = constant_of(p, values);
  const model::DesiredTransforms desired = random_desired(seed, constant);
  const InterpretedRobot a(p.robot, random_desired(seed, p.robot), pass::names(), values), b(constant, desired, {});
  std::string text = check_all(a, seed, 1).failure_report();

  const reflection::Robot tables = b.tables();
  std::mt19937_64 engine(seed);
  const Sample s = reference::random_sample(engine, tables);
  const reference::Case c(tables, s, 0);
  const reference::Arguments given{&s.gravity, &s.external};
  const reference::Loads<Real> loads = reference::loads<Real>(s.gravity, s.external);
  const auto compare = [&](const char* name, const Vector<double>& x, const Vector<double>& y,
                           const Vector<Real>& terms) {
    const Real error = reference::blockwise_error(c.floating, x, y.cast<Real>(), terms);
    if (!(error <= kSame)) text += std::string(name) + ": " + std::to_string(static_cast<double>(error)) + "\n";
  };
  compare(
      "inverse dynamics", a.inverse_dynamics_fully_actuated(s.motion, given),
      b.inverse_dynamics_fully_actuated(s.motion, given), reference::expected_forces(c, s.motion, loads).terms);
  const Vector<double> tau = inverse_dynamics(tables, c.motion, loads).tau.cast<double>();
  compare(
      "forward dynamics", a.forward_dynamics(s.motion, tau, given), b.forward_dynamics(s.motion, tau, given),
      reference::expected_accelerations(c, tau, loads).terms);
  return text;
}

TEST(Parameters, FedWithValuesAreConstants) {
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 20); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 20000;
    const KinematicTree robot = random_robot(seed, {.max_joints = 12});
    const Parametric p = parametric(robot, seed);
    const std::string found = difference(p, p.values, seed);
    if (found.empty()) continue;
    const auto fails = [&](const KinematicTree& r) {
      const Parametric q = parametric(r, seed);
      return !difference(q, q.values, seed).empty();
    };
    FAIL() << "seed " << seed << "\n" << found << describe(parametric(shrink(robot, fails), seed).robot);
  }
}

// The same programs with other lengths, angles and masses. A body whose mass properties all grow by one factor remains
// physical, whatever the other values are.
TEST(Parameters, FedWithOtherValuesAreTheOtherRobot) {
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 20); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 30000;
    KinematicTree robot = random_robot(seed, {.max_joints = 12});
    // Parameter 0 is a factor of all masses and inertias, parameter 1 of all lengths; parameter 2 is added to all
    // angles.
    robot.parameters = {
        {"size", ParameterKind::inertial, {}, {}},
        {"stretch", ParameterKind::length, {}, {}},
        {"twist", ParameterKind::angle, {}, {}}};
    for_each_quantity(robot, [](Quantity& q, ParameterKind kind) {
      if (kind == ParameterKind::length) q = Quantity::parameter(1) * q;
      if (kind == ParameterKind::angle) q = q + Quantity::parameter(2);
    });
    for (model::Link& link : robot.links) {
      if (!link.inertia) continue;
      model::Inertia& I = *link.inertia;
      for (Quantity* q : {&I.mass, &I.ixx, &I.iyy, &I.izz, &I.ixy, &I.ixz, &I.iyz}) *q = Quantity::parameter(0) * *q;
    }
    const Parametric p{robot, {}};
    for (const std::vector<double>& values : {std::vector<double>{1, 1, 0}, {3.5, 1.7, 0.4}, {0.2, 0.6, -1.3}})
      ASSERT_EQ(difference(p, values, seed), "") << "seed " << seed << "\n" << describe(robot);
  }
}

// Signs and factors move, so products are rounded differently. Forward dynamics magnifies this by its condition number:
// where the mass properties are not physical, forces of order one cause accelerations of 1e6.
constexpr double kMagnifiedRounding = 1e-9;

// Splits all programs of the robot: the results from the cache are the same, also after an update of only one
// interface.
TEST(Parameters, SplitOffChangeNoResult) {
  for (int i = 0; i < volume("ROBCOGEN_TEST_ROBOTS", 20); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 40000;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const KinematicTree constant = random_robot(seed, {.max_joints = 12});
    const Parametric p = parametric(constant, seed);
    if (p.values.empty()) continue;
    std::vector<symbolic::Program> programs;
    for (const std::string& group : algorithm::groups())
      for (const symbolic::Function& f : algorithm::functions(p.robot, random_desired(seed, p.robot), group))
        programs.push_back(f.program);
    std::vector<pass::Interfaces> interfaces;
    for (const model::Parameter& parameter : p.robot.parameters)
      interfaces.push_back({model::is_kinematics(parameter), model::is_dynamics(parameter)});
    const pass::SplitPrograms split = pass::split_parameters(programs, interfaces);

    std::mt19937_64 engine(seed);
    std::vector<double> values = p.values;
    const auto part = [&](const symbolic::Program& update) {
      return symbolic::interpret<double>(update, {{"parameters", values}}).at("cache");
    };
    std::vector<double> kinematics = part(split.kinematics), dynamics = part(split.dynamics), both = part(split.both);
    const auto expect_equal_results = [&] {
      std::vector<double> cache = kinematics;
      cache.insert(cache.end(), dynamics.begin(), dynamics.end());
      cache.insert(cache.end(), both.begin(), both.end());
      for (std::size_t k = 0; k < programs.size(); ++k) {
        EXPECT_EQ(symbolic::verify(split.programs[k]), "");
        symbolic::Arrays<double> inputs;
        for (const symbolic::InputArray& array : programs[k].inputs)
          for (std::size_t e = 0; e < array.elements.size(); ++e)
            inputs[array.name].push_back(reference::uniform(engine, 2));
        // Functions of a given factor have no parameters.
        const auto parameters = inputs.find("parameters");
        if (parameters != inputs.end()) parameters->second = values;
        const symbolic::Arrays<double> expected = symbolic::interpret<double>(programs[k], inputs);
        if (parameters != inputs.end()) parameters->second = cache;
        // Where the mass properties are not physical, the factor of the inertia matrix has roots of negative numbers.
        const bool has_roots = symbolic::cost(programs[k]).sqrt > 0;
        for (const auto& [name, found] : symbolic::interpret<double>(split.programs[k], inputs)) {
          // Inputs are of order one, so a much smaller value is a rounded zero.
          double scale = 1e-4;
          for (const double x : expected.at(name)) scale = std::max(scale, std::abs(x));
          for (std::size_t e = 0; e < found.size(); ++e) {
            if (has_roots && std::isnan(found[e]) && std::isnan(expected.at(name)[e])) continue;
            EXPECT_NEAR(found[e], expected.at(name)[e], kMagnifiedRounding * scale)
                << programs[k].name << " " << name << " " << e;
          }
        }
      }
    };
    expect_equal_results();
    for (const bool dynamic : {true, false}) {
      for (std::size_t k = 0; k < values.size(); ++k)
        if (dynamic ? interfaces[k].dynamics : interfaces[k].kinematics) values[k] *= 1.1;
      (dynamic ? dynamics : kinematics) = part(dynamic ? split.dynamics : split.kinematics);
      both = part(split.both);
      expect_equal_results();
    }
  }
}

}  // namespace
}  // namespace robcogen::numeric::parameters_test
