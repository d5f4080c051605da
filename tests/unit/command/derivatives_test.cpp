// The option `--derivatives` of the subcommands: results compared with differences, and messages.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "run_tool.h"

namespace robcogen::test::derivatives_test {
namespace {

using nlohmann::json;

const std::filesystem::path kLeg = ROBCOGEN_ROBOTS_DIR "/hyl_parametric/hyl_parametric.kindsl";
const std::filesystem::path kHyl = ROBCOGEN_ROBOTS_DIR "/hyl/hyl.kindsl";
const std::filesystem::path kEuler = ROBCOGEN_ROBOTS_DIR "/euler/euler.motdsl";

json results_of(
    const std::filesystem::path& model,
    const std::string& function,
    const std::string& options,
    const json& state) {
  const Outcome run = run_tool("eval --quiet " + quoted(model) + " " + function + " " + options, state.dump());
  EXPECT_EQ(run.status, 0) << run.errors;
  return json::parse(run.output);
}

// The elements of a matrix, column by column, or of a vector.
std::vector<double> flat(const json& values) {
  std::vector<double> result;
  if (values.empty() || !values[0].is_array()) return values.get<std::vector<double>>();
  for (std::size_t c = 0; c < values[0].size(); ++c)
    for (const json& row : values) result.push_back(row[c].get<double>());
  return result;
}

// Returns the state with a step added to the element `name` of `input`, which is given by name or by index.
json moved(json state, const std::string& input, const json& name, double step) {
  json& element = name.is_string() ? state[input][name.get<std::string>()] : state[input][name.get<std::size_t>()];
  element = element.get<double>() + step;
  return state;
}

// Compares each column with central differences of the function itself.
void expect_derivatives(
    const std::filesystem::path& model,
    const std::string& function,
    const std::string& input,
    const std::string& output,
    const std::vector<json>& elements,
    const json& state) {
  constexpr double kStep = 1e-5, kNear = 1e-7;
  const std::string options = "--derivatives " + function + ":" + input;
  const json found = results_of(model, function + "_d_" + input, options, state);
  EXPECT_EQ(found[output], results_of(model, function, "", state)[output]);
  const json& rows = found["d_" + input];
  for (std::size_t column = 0; column < elements.size(); ++column) {
    const auto at = [&](double step) {
      return flat(results_of(model, function, "", moved(state, input, elements[column], step))[output]);
    };
    const std::vector<double> after = at(kStep), before = at(-kStep);
    ASSERT_EQ(rows.size(), after.size());
    for (std::size_t r = 0; r < after.size(); ++r) {
      ASSERT_EQ(rows[r].size(), elements.size());
      EXPECT_NEAR(rows[r][column].get<double>(), (after[r] - before[r]) / (2 * kStep), kNear) << r << ", " << column;
    }
  }
}

json parameters_of_leg() {
  return {
      {"slider_mass", 4.0},
      {"upperleg_mass", 2.6},
      {"lowerleg_mass", 0.9},
      {"upperleg_length", 0.35},
      {"lowerleg_length", 0.33}};
}

TEST(Derivatives, ByPositionsAndByParameters) {
  const json state = {
      {"q", {0.1, 0.4, -0.9}}, {"qd", {0.5, -1, 2}}, {"qdd", {1, 2, 3}}, {"parameters", parameters_of_leg()}};
  expect_derivatives(kLeg, "inverse_dynamics", "qd", "tau", {0, 1, 2}, state);
  const json still = {{"q", {0.1, 0.4, -0.9}}, {"parameters", parameters_of_leg()}};
  const std::string foot = "jacobians.fr_base_J_fr_foot";
  const json with_d = results_of(kLeg, foot + "_d_parameters", "--derivatives " + foot + ":parameters", still);
  const std::size_t columns = with_d["d_parameters"][0].size();
  ASSERT_EQ(columns, parameters_of_leg().size());
  double largest = 0;
  for (const json& row : with_d["d_parameters"])
    for (const json& x : row) largest = std::max(largest, std::abs(x.get<double>()));
  EXPECT_NEAR(largest, 1.0, 0.3);  // derivative of a lever arm with respect to a length: a cosine or a sine
}

// The contact frames are those of the desired transforms.
TEST(Derivatives, OfContacts) {
  const std::string contacts = " --contacts fr_foot:point";
  const json state = {
      {"q", {0.1, 0.4, -0.9}}, {"qd", {0.5, -1, 2}}, {"qdd", {1, 2, 3}}, {"parameters", parameters_of_leg()}};
  const auto velocity = [&](double step) {
    json moved_state = moved(state, "q", 1, step);
    moved_state.erase("qdd");
    return results_of(kLeg, "contact_velocity", contacts, moved_state)["velocity"].get<std::vector<double>>();
  };
  json still = state;
  still.erase("qdd");
  const json found =
      results_of(kLeg, "contact_velocity_d_q", contacts + " --derivatives contact_velocity:q", still)["d_q"];
  ASSERT_EQ(found.size(), 3U);
  const std::vector<double> after = velocity(1e-5), before = velocity(-1e-5);
  for (std::size_t row = 0; row < 3; ++row)
    EXPECT_NEAR(found[row][1].get<double>(), (after[row] - before[row]) / 2e-5, 1e-7) << row;
  const Outcome ops = run_tool(
      "ops " + quoted(kLeg) + " --json --effort 0 --algorithms contacts --derivatives contact_jacobian:parameters" +
          contacts,
      "");
  EXPECT_NE(ops.output.find("\"contact_jacobian_d_parameters\""), std::string::npos) << ops.errors;
}

// The base turns about its own axes, under gravity that is fixed in the world.
TEST(Derivatives, ByTheRotationOfTheBase) {
  const std::filesystem::path model = ROBCOGEN_ROBOTS_DIR "/quadruped/quadruped.kindsl";
  const json zero = std::vector<double>(12, 0.2);
  const auto at = [&](std::size_t axis, double step) {
    const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
    const std::array<double, 3> g = {1.0, 2.0, -9.0};
    std::array<double, 3> turned = g;
    turned[y] = std::cos(step) * g[y] + std::sin(step) * g[z];
    turned[z] = std::cos(step) * g[z] - std::sin(step) * g[y];
    return json{
        {"q", zero},
        {"qd", zero},
        {"qdd", zero},
        {"gravity", turned},
        {"base_velocity", {1, 2, 3, 4, 5, 6}},
        {"base_acceleration", {6, 5, 4, 3, 2, 1}}};
  };
  const std::string options =
      "--derivatives inverse_dynamics_fully_actuated:base_rotation world.position_fr_LF_foot:base_rotation";
  const json found = results_of(model, "inverse_dynamics_fully_actuated_d_base_rotation", options, at(0, 0));
  constexpr double kStep = 1e-4;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const json after = results_of(model, "inverse_dynamics_fully_actuated", "", at(axis, kStep));
    const json before = results_of(model, "inverse_dynamics_fully_actuated", "", at(axis, -kStep));
    for (const char* result : {"tau", "base_wrench"}) {
      const std::vector<double> a = flat(after[result]), b = flat(before[result]);
      const json& rows = found[std::string(result) + "_d_base_rotation"];
      ASSERT_EQ(rows.size(), a.size());
      for (std::size_t r = 0; r < a.size(); ++r) {
        ASSERT_EQ(rows[r].size(), 3U);
        EXPECT_NEAR(rows[r][axis].get<double>(), (a[r] - b[r]) / (2 * kStep), 1e-5) << result << r << ' ' << axis;
      }
    }
  }

  // The pose of the base holds its rotation too: a foot at p turns with the velocity axis x p.
  const std::string foot = "world.position_fr_LF_foot";
  const json pose = {{"q", zero}, {"base_pose", {1, 0, 0, 0, 0, 0, 0}}};
  const json turned = results_of(model, foot + "_d_base_rotation", options, pose);
  const std::vector<double> p = results_of(model, foot, "", pose)["p"];
  const double expected[3][3] = {{0, p[2], -p[1]}, {-p[2], 0, p[0]}, {p[1], -p[0], 0}};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(turned["d_base_rotation"][r][axis].get<double>(), expected[r][axis], 1e-14);
}

// The numbers of an array of results or arguments, in their order.
std::vector<double> numbers(const json& values) {
  return values.is_array() ? flat(values) : std::vector<double>{values.get<double>()};
}

// Weights times a tangent is a gradient times rates: both are weights times the matrix times rates. The matrix is that
// of
// `--derivatives`, which is compared with differences above.
void expect_products(
    const std::filesystem::path& model,
    const std::string& function,
    const std::string& input,
    json state,
    const std::vector<double>& weights,
    const std::vector<double>& rates) {
  const std::string of_input = " " + function + ":" + input;
  const json matrix = results_of(model, function + "_d_" + input, "--derivatives" + of_input, state);
  const std::vector<double> d = flat(matrix["d_" + input]);
  ASSERT_EQ(d.size(), weights.size() * rates.size());
  state["weights"] = weights;
  const json gradient = results_of(model, function + "_gradient_" + input, "--gradients" + of_input, state);
  state.erase("weights");
  state[input + "_tangent"] = rates;
  const json tangent = results_of(model, function + "_tangent_" + input, "--tangents" + of_input, state);
  std::vector<double> expected_gradient(rates.size()), expected_tangent(weights.size());
  for (std::size_t c = 0; c < rates.size(); ++c) {
    for (std::size_t r = 0; r < weights.size(); ++r) {
      expected_gradient[c] += weights[r] * d[r + c * weights.size()];
      expected_tangent[r] += rates[c] * d[r + c * weights.size()];
    }
  }
  const std::string result =
      matrix.begin().key() == "d_" + input ? std::next(matrix.begin()).key() : matrix.begin().key();
  const std::vector<double> found_gradient = numbers(gradient["d_" + input]);
  const std::vector<double> found_tangent = numbers(tangent[result + "_tangent"]);
  ASSERT_EQ(found_gradient.size(), rates.size());
  ASSERT_EQ(found_tangent.size(), weights.size());
  for (std::size_t c = 0; c < rates.size(); ++c) EXPECT_NEAR(found_gradient[c], expected_gradient[c], 1e-10) << c;
  for (std::size_t r = 0; r < weights.size(); ++r) EXPECT_NEAR(found_tangent[r], expected_tangent[r], 1e-10) << r;
  EXPECT_EQ(gradient[result], matrix[result]);
  EXPECT_EQ(tangent[result], matrix[result]);
}

TEST(Derivatives, TimesVectors) {
  const json state = {
      {"q", {0.1, 0.4, -0.9}}, {"qd", {0.5, -1, 2}}, {"tau", {1, 2, 3}}, {"parameters", parameters_of_leg()}};
  expect_products(kLeg, "forward_dynamics", "q", state, {1, -2, 0.5}, {0.3, 1, -1});
  expect_products(kLeg, "forward_dynamics", "parameters", state, {1, -2, 0.5}, {0.3, 1, -1, 2, 0.1});
  // A ball joint turns about three axes.
  const std::filesystem::path ball_leg = ROBCOGEN_ROBOTS_DIR "/ball_leg/ball_leg.kindsl";
  const json bent = {{"q", {0.5, 0.5, -0.5, 0.5, 0.3, 0.8, 0.0, 0.6, 0.0}}};
  expect_products(ball_leg, "potential_energy", "q", bent, {2}, {1, 2, 3, 4, 5, 6, 7});
  const std::filesystem::path quadruped = ROBCOGEN_ROBOTS_DIR "/quadruped/quadruped.kindsl";
  const json pose = {{"q", std::vector<double>(12, 0.2)}, {"base_pose", {0.5, -0.5, 0.5, 0.5, 1, 2, 3}}};
  for (const char* input : {"base_rotation", "base_pose"}) {
    const std::size_t count = input == std::string("base_pose") ? 6 : 3;
    std::vector<double> rates = {1, -2, 3, 4, 5, -6};
    rates.resize(count);
    expect_products(quadruped, "world.position_fr_LF_foot", input, pose, {1, 2, -3}, rates);
  }
  // The dependent joints of loops move with the others.
  const std::filesystem::path five_bar = ROBCOGEN_ROBOTS_DIR "/five_bar/five_bar.kindsl";
  const json closed = {{"q", {0.1, -0.1}}, {"qd", {1, 2}}, {"qdd", {-1, 1}}};
  expect_products(five_bar, "inverse_dynamics", "q", closed, {1, -2}, {0.3, 1});
}

// A Hessian times a vector: how the gradient changes.
TEST(Derivatives, OfDerivatives) {
  const std::string first = "forward_dynamics_gradient_q",
                    options = "--gradients forward_dynamics:q --tangents " + first + ":q";
  json state = {
      {"q", {0.1, 0.4, -0.9}},
      {"qd", {0.5, -1, 2}},
      {"tau", {1, 2, 3}},
      {"parameters", parameters_of_leg()},
      {"weights", {1.0, -2.0, 0.5}}};
  const std::vector<double> rates = {0.3, 1, -1};
  const auto gradient = [&](double step) {
    json there = state;
    for (std::size_t k = 0; k < rates.size(); ++k) there["q"][k] = there["q"][k].get<double>() + step * rates[k];
    return flat(results_of(kLeg, first, options, there)["d_q"]);
  };
  constexpr double kStep = 1e-5;
  const std::vector<double> after = gradient(kStep), before = gradient(-kStep);
  state["q_tangent"] = rates;
  const std::vector<double> found = flat(results_of(kLeg, first + "_tangent_q", options, state)["d_q_tangent"]);
  ASSERT_EQ(found.size(), rates.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k], (after[k] - before[k]) / (2 * kStep), 1e-6 * (1 + std::abs(found[k]))) << k;
}

TEST(Derivatives, OfTransforms) {
  expect_derivatives(
      kEuler, "transforms.motion.S_X_zyx", "variables", "X", {"a", "b", "c"},
      {{"variables", {{"a", 0.1}, {"b", 0.2}, {"c", 0.3}}}});
}

// `ops` lists the derivatives, `print --program` prints them, and the list of files follows from the options alone.
TEST(Derivatives, OfAllSubcommands) {
  const std::string options = " --derivatives center_of_mass:q potential_energy:q,parameters";
  const Outcome ops = run_tool("ops " + quoted(kLeg) + " --json --effort 0 --algorithms energy" + options, "");
  ASSERT_EQ(ops.status, 0) << ops.errors;
  EXPECT_NE(ops.output.find("\"center_of_mass_d_q\""), std::string::npos);
  EXPECT_NE(ops.output.find("\"potential_energy_d_q_parameters\""), std::string::npos);
  const Outcome text = run_tool("print " + quoted(kLeg) + " --program center_of_mass_d_q" + options, "");
  EXPECT_EQ(text.status, 0) << text.errors;
  EXPECT_NE(text.output.find("output d_q matrix 3 3"), std::string::npos) << text.output;
  const Outcome files = run_tool("generate --list-outputs --name a --batch" + options, "");
  for (const char* file : {"a/kernel/derivatives.h\n", "a/derivatives.cpp\n", "a/batch/derivatives_avx2.cpp\n"})
    EXPECT_NE(files.output.find(file), std::string::npos) << file;
}

// The gradient of a single result is computed in reverse mode, which costs less than a column for each joint.
TEST(Derivatives, TakeTheCheaperMode) {
  const std::filesystem::path model = ROBCOGEN_ROBOTS_DIR "/humanoid/humanoid.kindsl";
  const Outcome run =
      run_tool("ops " + quoted(model) + " --json --effort 0 --algorithms energy --derivatives kinetic_energy:q", "");
  ASSERT_EQ(run.status, 0) << run.errors;
  const json report = json::parse(run.output);
  std::map<std::string, int> operations;
  for (const json& f : report["functions"]) operations[f["name"]] = f["mul"].get<int>() + f["add"].get<int>();
  EXPECT_LT(operations.at("kinetic_energy_d_q"), 4 * operations.at("kinetic_energy"));
}

struct Fault {
  const char* derivative;
  const char* message;
};

class WrongDerivatives : public testing::TestWithParam<Fault> {};

TEST_P(WrongDerivatives, AreRefused) {
  const Outcome run =
      run_tool("ops " + quoted(kLeg) + " --algorithms energy --derivatives " + GetParam().derivative, "");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.output, "");
  EXPECT_NE(run.errors.find(GetParam().message), std::string::npos) << run.errors;
}

INSTANTIATE_TEST_SUITE_P(
    All,
    WrongDerivatives,
    testing::Values(
        Fault{
            "inverse_dynamic:q",
            "has no function 'inverse_dynamic' [unknown-function]\nhint: did you mean 'inverse_dynamics'?"},
        Fault{"kDof:q", "has no function 'kDof' [unknown-function]"},
        Fault{
            "inverse_dynamics:qq",
            "'qq' is not an argument of inverse_dynamics, which takes parameters, q, qd, qdd, gravity, external "
            "[unknown-argument]\nhint: did you mean 'qd'?"},
        Fault{"inverse_dynamics:tau", "'tau' is a result, not an argument of inverse_dynamics, which takes parameters"},
        Fault{
            "joint_space_inertia:base_rotation",
            "joint_space_inertia takes parameters, q, neither gravity nor the pose of the base, and does not depend on "
            "how the base is oriented [no-orientation]"},
        Fault{"inverse_dynamics:base_rotatoin", "hint: did you mean 'base_rotation'?"},
        Fault{"inverse_dynamics:0", "'0' is not the name of an input"},
        Fault{
            "inverse_dynamics",
            "no input to differentiate with respect to [wrong-derivative]\nhint: write function:input"},
        Fault{":q", "no function to differentiate"},
        Fault{"inverse_dynamics:q,,qd", "an input without a name"},
        Fault{"inverse_dynamics:q,q", "'q' is given twice"},
        Fault{"inertia_factor.solve:x", "functions of an inertia factor take an object"},
        Fault{"jacobians.fr_base_J_foot:q", "has no function 'jacobians.fr_base_J_foot'"}));

// The names of functions in the list of `ops`.
std::vector<std::string> functions_with(const std::string& options) {
  const Outcome run = run_tool("ops --json " + quoted(kHyl) + " " + options, "");
  EXPECT_EQ(run.status, 0) << run.errors;
  const json list = json::parse(run.output);
  std::vector<std::string> names;
  for (const json& f : list["functions"]) names.push_back(f["name"]);
  return names;
}

TEST(Derivatives, All) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(
      functions_with("--algorithms energy joint_space_inertia_factor --gradients all"),
      (Names{
          "joint_space_inertia_factor", "inertia_factor.solve", "inertia_factor.inverse", "inertia_factor.inverse_L",
          "kinetic_energy", "potential_energy", "joint_space_inertia_factor_gradient_q", "kinetic_energy_gradient_q_qd",
          "potential_energy_gradient_q"}));
  // Functions that are named, or have derivatives among their results, get no others; gravity is one of the loads.
  EXPECT_EQ(
      functions_with("--algorithms energy inverse_dynamics_derivatives --tangents all --derivatives kinetic_energy:qd"),
      (Names{
          "inverse_dynamics_derivatives", "gravity_forces_derivative", "kinetic_energy", "potential_energy",
          "kinetic_energy_d_qd", "potential_energy_tangent_q"}));
  const json state = {{"q", {0.3, -0.4, 0.5}}, {"weights", {1.0}}};
  const json found = results_of(kLeg, "potential_energy_gradient_q", "--gradients all", state);
  EXPECT_EQ(found, results_of(kLeg, "potential_energy_gradient_q", "--gradients potential_energy:q", state));
}

TEST(Derivatives, MessagesNameTheirOption) {
  const auto errors = [](const std::string& options) {
    const Outcome run = run_tool("ops " + quoted(kLeg) + " --algorithms energy " + options, "");
    EXPECT_EQ(run.status, 2);
    return run.errors;
  };
  EXPECT_NE(errors("--gradients bias_forces:qq").find("--gradients bias_forces:qq: 'qq' is not an"), std::string::npos);
  EXPECT_NE(errors("--tangents bias_forces").find("--tangents 'bias_forces': no input to"), std::string::npos);
  EXPECT_NE(
      errors("--tangents bias_forces:q bias_forces_tangent_q:q")
          .find("bias_forces_tangent_q has 'q_tangent' already, an argument or a result [repeated-derivative]"),
      std::string::npos);
}

TEST(Derivatives, ByWhichContactsHold) {
  const Outcome run = run_tool(
      "ops " + quoted(kLeg) +
          " --algorithms contacts --contacts fr_foot:point --derivatives constrained_forward_dynamics:q,active",
      "");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(
      run.errors.find("--derivatives constrained_forward_dynamics:q,active: the elements of 'active' are switches, 0 "
                      "or 1; constrained_forward_dynamics also takes parameters, q, qd, tau"),
      std::string::npos)
      << run.errors;
}

#if ROBCOGEN_TEST_EVERYTHING
// The message names the group that has such derivatives.
TEST(Derivatives, TooLongWithContacts) {
  const std::filesystem::path model = ROBCOGEN_ROBOTS_DIR "/humanoid/humanoid.kindsl";
  const Outcome run = run_tool(
      "ops " + quoted(model) +
          " --effort 0 --contacts fr_left_sole:surface,fr_right_sole:surface --derivatives "
          "constrained_forward_dynamics:q,qd,tau",
      "");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.errors.find("[too-many-operations]"), std::string::npos) << run.errors;
  EXPECT_NE(
      run.errors.find("hint: constrained_forward_dynamics_derivatives, of the group "
                      "constrained_forward_dynamics_derivatives, has derivatives by q, qd, tau, contact_acceleration, "
                      "base_velocity, base_rotation, in shorter code"),
      std::string::npos)
      << run.errors;
}
#endif

// Second derivatives of a humanoid's inverse dynamics are too long for a compiler.
TEST(Derivatives, TooLong) {
  const std::filesystem::path model = ROBCOGEN_ROBOTS_DIR "/humanoid/humanoid.kindsl";
  const Outcome run = run_tool(
      "eval " + quoted(model) +
          " inverse_dynamics_fully_actuated_derivatives_d_q_qd --derivatives "
          "inverse_dynamics_fully_actuated_derivatives:q,qd",
      "");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.errors.find("[too-many-operations]"), std::string::npos) << run.errors;
}

}  // namespace
}  // namespace robcogen::test::derivatives_test
