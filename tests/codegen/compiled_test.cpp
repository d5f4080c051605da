// Compares compiled functions with the interpreter, which runs the same programs without a compiler.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cart_pole/cart_pole.h"
#include "legs/floating/hopper/hopper.h"
#include "my/robcogen/class/robot/robot.h"
#include "plinth/plinth.h"
#include "samples.h"
#include "symbolic/interpret.h"

namespace robcogen::test::compiled_test {
namespace {

// The compiler may fuse a product into a sum, the interpreter does not: the results differ by a few roundings of terms
// of size one.
constexpr double kRounding = 1e-13;
constexpr double kFloatRounding = 1e-4;
constexpr int kStates = 50;

using Arrays = symbolic::Arrays<double>;

std::vector<double> values(const double* data, Eigen::Index size) {
  return {data, data + size};
}

template <class Vector>
std::vector<double> values(const Vector& v) {
  return values(v.data(), v.size());
}

// Random arrays for every input of every function of a library.
class Inputs {
 public:
  template <class Vector>
  Vector take(const std::string& name) {
    Vector v;
    for (Eigen::Index k = 0; k < v.size(); ++k) v.data()[k] = distribution_(random_);
    arrays_[name] = values(v);
    return v;
  }

  // Returns the program's outputs for the arrays that were taken; other inputs are zero, or given by `extra`.
  Arrays run(const backend::Library& library, const std::string& kernel, const Arrays& extra = {}) const {
    for (const backend::Function& f : library.functions) {
      if (f.kernel != kernel) continue;
      Arrays inputs;
      for (const symbolic::InputArray& input : f.program.inputs) {
        if (const auto given = arrays_.find(input.name); given != arrays_.end()) inputs.insert(*given);
        if (const auto given = extra.find(input.name); given != extra.end()) inputs[input.name] = given->second;
      }
      return symbolic::interpret(f.program, inputs);
    }
    ADD_FAILURE() << "no kernel " << kernel;
    return {};
  }

 private:
  std::mt19937 random_{42};
  std::uniform_real_distribution<double> distribution_{-1.5, 1.5};
  Arrays arrays_;
};

void expect_near(const double* actual, Eigen::Index size, const std::vector<double>& expected) {
  ASSERT_EQ(static_cast<std::size_t>(size), expected.size());
  for (Eigen::Index k = 0; k < size; ++k) {
    const double wanted = expected[static_cast<std::size_t>(k)];
    EXPECT_NEAR(actual[k], wanted, kRounding * (1 + std::abs(wanted))) << "element " << k;
  }
}

template <class Matrix>
void expect_near(const Eigen::MatrixBase<Matrix>& actual, const std::vector<double>& expected) {
  const auto plain = actual.eval();
  expect_near(plain.data(), plain.size(), expected);
}

const Arrays kStandard = {{"gravity", {0, 0, -9.81}}};

TEST(Compiled, FixedBaseDynamics) {
  const backend::Library library = cart_pole();
  Inputs in;
  for (int state = 0; state < kStates; ++state) {
    const auto q = in.take<cart_pole::JointState>("q"), qd = in.take<cart_pole::JointState>("qd");
    const auto qdd = in.take<cart_pole::JointState>("qdd"), tau = in.take<cart_pole::JointState>("tau");
    const Gravity g(in.take<Eigen::Vector3d>("gravity"));
    const auto wrenches = in.take<Eigen::Matrix<double, 6, 3>>("external");
    cart_pole::LinkWrenches external;
    for (int link = 0; link < cart_pole::kLinkCount; ++link) external[link] = Wrench(wrenches.col(link));

    using namespace cart_pole;
    const auto expect = [&](const JointState& actual, const char* kernel, const char* output,
                            const Arrays& extra = {}) {
      SCOPED_TRACE(kernel);
      expect_near(actual, in.run(library, kernel, extra).at(output));
    };
    expect(inverse_dynamics(q, qd, qdd), "inverse_dynamics", "tau");
    expect(inverse_dynamics(q, qd, qdd, g), "inverse_dynamics_gravity", "tau");
    expect(inverse_dynamics(q, qd, qdd, g, external), "inverse_dynamics_external", "tau");
    expect(inverse_dynamics(q, qd, qdd, external), "inverse_dynamics_external", "tau", kStandard);
    expect(forward_dynamics(q, qd, tau), "forward_dynamics", "qdd");
    expect(forward_dynamics(q, qd, tau, g), "forward_dynamics_gravity", "qdd");
    expect(forward_dynamics(q, qd, tau, g, external), "forward_dynamics_external", "qdd");
    expect(forward_dynamics(q, qd, tau, external), "forward_dynamics_external", "qdd", kStandard);
    expect(bias_forces(q, qd), "bias_forces", "tau");
    expect(bias_forces(q, qd, g), "bias_forces_gravity", "tau");
    expect(bias_forces(q, qd, g, external), "bias_forces_external", "tau");
    expect(bias_forces(q, qd, external), "bias_forces_external", "tau", kStandard);
    expect(gravity_forces(q), "gravity_forces", "tau");
    expect(gravity_forces(q, g), "gravity_forces_gravity", "tau");
    expect(coriolis_forces(q, qd), "coriolis_forces", "tau");
    expect_near(joint_space_inertia(q), in.run(library, "joint_space_inertia").at("H"));
    const InertiaFactor factor = joint_space_inertia_factor(q);
    const Arrays factored = in.run(library, "joint_space_inertia_factor");
    expect_near(factor.L(), factored.at("L"));
    expect_near(factor.inverse_diagonal(), factored.at("inverse_diagonal"));
    expect_near(transforms::homogeneous::fr_base_X_fr_tip(q), in.run(library, "homogeneous_fr_base_X_fr_tip").at("X"));
    expect_near(transforms::motion::fr_base_X_fr_tip(q), in.run(library, "motion_fr_base_X_fr_tip").at("X"));
    expect_near(transforms::force::fr_base_X_fr_tip(q), in.run(library, "force_fr_base_X_fr_tip").at("X"));
    expect_near(jacobians::fr_base_J_fr_tip(q), in.run(library, "fr_base_J_fr_tip").at("J"));
  }
}

// Physical identities between the functions hold for every implementation.
TEST(Compiled, FunctionsOfOneRobotAgree) {
  using namespace cart_pole;
  Inputs in;
  for (int state = 0; state < kStates; ++state) {
    const auto q = in.take<JointState>("q"), qd = in.take<JointState>("qd"), qdd = in.take<JointState>("qdd");
    const JointState tau = inverse_dynamics(q, qd, qdd);
    EXPECT_TRUE(forward_dynamics(q, qd, tau).isApprox(qdd, 1e-12));
    EXPECT_TRUE((joint_space_inertia(q) * qdd + bias_forces(q, qd)).isApprox(tau, 1e-12));
    const InertiaFactor factor = joint_space_inertia_factor(q);
    EXPECT_TRUE((factor.L().transpose() * factor.L()).isApprox(joint_space_inertia(q), 1e-12));
    EXPECT_TRUE((factor.inverse() * joint_space_inertia(q)).isIdentity(1e-12));
    EXPECT_TRUE((factor.inverse_L() * factor.L()).isIdentity(1e-12));
    EXPECT_TRUE(factor.solve(tau - bias_forces(q, qd)).isApprox(qdd, 1e-12));
    EXPECT_TRUE((gravity_forces(q) + coriolis_forces(q, qd)).isApprox(bias_forces(q, qd), 1e-12));
    const Eigen::Matrix<double, 6, 6> identity =
        transforms::force::fr_base_X_fr_tip(q).transpose() * transforms::motion::fr_base_X_fr_tip(q);
    EXPECT_TRUE(identity.isIdentity(1e-13));
  }
}

TEST(Compiled, FloatingBaseDynamics) {
  const backend::Library library = hopper();
  Inputs in;
  namespace robot = legs::floating::hopper;
  for (int state = 0; state < kStates; ++state) {
    const auto q = in.take<robot::JointState>("q"), qd = in.take<robot::JointState>("qd");
    const auto qdd = in.take<robot::JointState>("qdd"), tau = in.take<robot::JointState>("tau");
    const Twist v(in.take<Eigen::Matrix<double, 6, 1>>("base_velocity"));
    const SpatialAcceleration a(in.take<Eigen::Matrix<double, 6, 1>>("base_acceleration"));
    const Gravity g(in.take<Eigen::Vector3d>("gravity"));
    const auto wrenches = in.take<Eigen::Matrix<double, 6, 2>>("external");
    robot::LinkWrenches external;
    external[robot::Link::trunk] = Wrench(wrenches.col(0));
    external[robot::Link::leg] = Wrench(wrenches.col(1));

    const auto expect = [&](const auto& actual, const std::string& kernel, const Arrays& extra = {}) {
      SCOPED_TRACE(kernel);
      const Arrays expected = in.run(library, kernel, extra);
      if constexpr (requires { actual.qdd; })
        expect_near(actual.qdd, expected.at("qdd"));
      else
        expect_near(actual.tau, expected.at("tau"));
      if constexpr (requires { actual.base_wrench; })
        expect_near(actual.base_wrench.vector(), expected.at("base_wrench"));
      else
        expect_near(actual.base_acceleration.vector(), expected.at("base_acceleration"));
    };
    // Every function with gravity, and also with external wrenches.
    const auto expect_all = [&](const std::string& kernel, const auto& call) {
      expect(call(kStandardGravity), kernel, kStandard);
      expect(call(g), kernel);
      expect(call(g, external), kernel + "_external");
    };
    expect_all(
        "inverse_dynamics", [&](const auto&... loads) { return robot::inverse_dynamics(q, qd, qdd, v, loads...); });
    expect_all("inverse_dynamics_fully_actuated", [&](const auto&... loads) {
      return robot::inverse_dynamics_fully_actuated(q, qd, qdd, v, a, loads...);
    });
    expect_all(
        "forward_dynamics", [&](const auto&... loads) { return robot::forward_dynamics(q, qd, tau, v, loads...); });
    expect_all("bias_forces", [&](const auto&... loads) { return robot::bias_forces(q, qd, v, loads...); });
    expect(robot::gravity_forces(q, g), "gravity_forces");
    expect(robot::coriolis_forces(q, qd, v), "coriolis_forces");
    expect_near(robot::joint_space_inertia(q), in.run(library, "joint_space_inertia").at("H"));
  }
}

TEST(Compiled, SinglePrecisionAgreesWithDouble) {
  Inputs in;
  for (int state = 0; state < kStates; ++state) {
    const auto q = in.take<cart_pole::JointState>("q"), qd = in.take<cart_pole::JointState>("qd");
    const auto tau = in.take<cart_pole::JointState>("tau");
    const Eigen::Vector3d g(1, 2, -9);
    const cart_pole::f32::JointState single = cart_pole::f32::forward_dynamics(
        q.cast<float>(), qd.cast<float>(), tau.cast<float>(), cart_pole::f32::Gravity(g.cast<float>()));
    const cart_pole::JointState exact = cart_pole::forward_dynamics(q, qd, tau, Gravity(g));
    EXPECT_TRUE(single.cast<double>().isApprox(exact, kFloatRounding)) << single << " for " << exact;
    EXPECT_TRUE(cart_pole::f32::joint_space_inertia_factor(q.cast<float>())
                    .solve(tau.cast<float>())
                    .cast<double>()
                    .isApprox(cart_pole::joint_space_inertia_factor(q).solve(tau), kFloatRounding));
    EXPECT_TRUE(cart_pole::f32::transforms::motion::fr_base_X_fr_tip(q.cast<float>())
                    .cast<double>()
                    .isApprox(cart_pole::transforms::motion::fr_base_X_fr_tip(q), kFloatRounding));
  }
  namespace robot = legs::floating::hopper;
  const float standard =
      robot::f32::gravity_forces(robot::f32::JointState(0.5f), robot::f32::Gravity::standard()).tau[0];
  EXPECT_FLOAT_EQ(standard, static_cast<float>(robot::gravity_forces(robot::JointState(0.5), kStandardGravity).tau[0]));
}

TEST(Compiled, RobotsWithoutJoints) {
  const plinth::JointState none;
  EXPECT_EQ(plinth::inverse_dynamics(none, none, none).size(), 0);
  EXPECT_EQ(plinth::forward_dynamics(none, none, none).size(), 0);
  EXPECT_EQ(plinth::joint_space_inertia(none).size(), 0);
  EXPECT_EQ(plinth::joint_space_inertia_factor(none).L().size(), 0);
  EXPECT_EQ(plinth::joint_space_inertia_factor(none).solve(none).size(), 0);
  EXPECT_EQ(cart_pole::jacobians::fr_base_J_fr_base(cart_pole::JointState::Zero()).cols(), 0);
}

TEST(Compiled, NastyNamesComputeTheSame) {
  const backend::Library library = nasty();
  Inputs in;
  namespace robot = my::robcogen_::class_::robot;
  const auto q = in.take<robot::JointState>("q"), qd = in.take<robot::JointState>("qd");
  expect_near(robot::inverse_dynamics(q, qd), in.run(library, "inverse_dynamics").at("tau"));
  expect_near(robot::jacobians::class_J_I(q), in.run(library, "class_J_I").at("J"));
}

}  // namespace
}  // namespace robcogen::test::compiled_test
