// `robcogen eval` compared with closed forms, and its messages.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "patterns.h"
#include "run_tool.h"

namespace robcogen::test::eval_test {
namespace {

using nlohmann::json;

constexpr double kRounding = 1e-14;

// A point mass of 2 kg on a massless rod of 0.5 m. The joint's z axis is the base's y axis; at q = 0 the rod lies along
// x.
const char* const kPendulum = R"(Robot Pendulum {
  RobotBase base { children { rod via hinge } }
  link rod { id = 1
    inertia_params { mass = 2.0 CoM = (0.5, 0.0, 0.0) Ix = 0.0 Iy = 0.5 Iz = 0.5 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }
    children {}
    frames { tip { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }
  r_joint hinge { ref_frame { translation = (0.0, 0.0, 1.0) rotation = (-PI/2.0, 0.0, 0.0) } }
})";

class Eval : public testing::Test {
 protected:
  Eval() { write_text(model_, kPendulum); }
  json eval(const std::string& function, const json& arguments) {
    const Outcome run = run_tool("eval " + quoted(model_) + " " + function, arguments.dump());
    EXPECT_EQ(run.status, 0) << run.errors;
    return json::parse(run.output);
  }
  Outcome run(const std::string& function, const std::string& arguments) {
    return run_tool("eval " + quoted(model_) + " " + function, arguments);
  }
  Scratch scratch_{"eval"};
  const std::filesystem::path model_ = scratch_.path / "pendulum.kindsl";
};

TEST_F(Eval, InverseDynamicsOfAPendulum) {
  const double q = 0.3, qdd = 1.5;
  // Turning by q about +y lowers the tip. Gravity pulls the joint in this direction, so holding it takes -m g l cos q.
  const double expected = 2.0 * 0.25 * qdd - 2.0 * 9.81 * 0.5 * std::cos(q);
  EXPECT_NEAR(
      eval("inverse_dynamics", {{"q", {q}}, {"qd", {7.0}}, {"qdd", {qdd}}})["tau"][0], expected, kRounding * 10);
}

TEST_F(Eval, GravityAndExternalWrenchesAreOptionalWithAFixedBase) {
  json rest = {{"q", {0}}, {"qd", {0}}, {"qdd", {0}}};
  EXPECT_NEAR(eval("inverse_dynamics", rest)["tau"][0], -9.81, kRounding * 10);
  rest["gravity"] = {0, 0, 0};
  EXPECT_EQ(eval("inverse_dynamics", rest)["tau"][0], 0.0);
}

TEST_F(Eval, ForwardDynamicsAndExternalWrench) {
  // Without gravity, a wrench of 3 N m about the link's z axis acts like a joint force.
  const json result = eval(
      "forward_dynamics",
      {{"q", {0}}, {"qd", {0}}, {"tau", {1.0}}, {"gravity", {0, 0, 0}}, {"external", {{"rod", {0, 0, 3, 0, 0, 0}}}}});
  EXPECT_NEAR(result["qdd"][0], 4.0 / 0.5, kRounding * 10);
}

TEST_F(Eval, MatricesAreNestedRows) {
  EXPECT_EQ(eval("joint_space_inertia", {{"q", {0.7}}})["H"], json::parse("[[0.5]]"));
  const json x = eval("transforms.homogeneous.fr_base_X_tip", {{"q", {0.0}}})["X"];
  const json expected = json::parse("[[1, 0, 0, 0.5], [0, 0, 1, 0], [0, -1, 0, 1], [0, 0, 0, 1]]");
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(x[r][c].get<double>(), expected[r][c].get<double>(), kRounding);
  const json j = eval("jacobians.fr_base_J_tip", {{"q", {0.0}}})["J"];
  ASSERT_EQ(j.size(), 6U);
  const double column[] = {0, 1, 0, 0, 0, -0.5};
  for (std::size_t r = 0; r < 6; ++r) EXPECT_NEAR(j[r][0].get<double>(), column[r], kRounding);
}

// The results of one function are arguments of the next one.
TEST_F(Eval, FactorOfTheInertiaMatrix) {
  json factor = eval("joint_space_inertia_factor", {{"q", {0.7}}});
  EXPECT_NEAR(factor["L"][0][0], std::sqrt(0.5), kRounding);
  EXPECT_NEAR(eval("inertia_factor.inverse", factor)["inverse"][0][0], 2.0, kRounding * 10);
  factor["x"] = {3.0};
  EXPECT_NEAR(eval("inertia_factor.solve", factor)["y"][0], 6.0, kRounding * 10);
  for (const char* wrong : {"1", "[1]", "[[1, 2]]", "[[1], [2]]", "[[\"1\"]]"}) {
    factor["L"] = json::parse(wrong);
    const Outcome refused = run("inertia_factor.solve", factor.dump());
    EXPECT_EQ(refused.status, 1) << wrong;
    EXPECT_NE(refused.errors.find("[wrong-shape]"), std::string::npos) << refused.errors;
  }
}

TEST_F(Eval, ResultsReadBackExactly) {
  const json result = eval("gravity_forces", {{"q", {0.1}}});
  const double value = result["tau"][0];
  EXPECT_NEAR(value, -9.81 * std::cos(0.1), kRounding * 10);
  EXPECT_EQ(json::parse(json(value).dump()).get<double>(), value);
}

// The complete message for each error in the input.
TEST_F(Eval, MessagesOfWrongInput) {
  const std::string list = R"(
note: arguments of inverse_dynamics:
  q: array of 1 number (hinge): joint positions (rad, m)
  qd: array of 1 number (hinge): joint velocities (rad/s, m/s)
  qdd: array of 1 number (hinge): joint accelerations (rad/s^2, m/s^2)
  gravity: array of 3 numbers (x, y, z): gravity (m/s^2) in base coordinates; optional, (0, 0, -9.81)
  external: object of name: array of 6 numbers (base, rod): wrench on each link, angular first, in axes of the frame fr_<link> about its origin; optional, zero)";
  const std::string others = R"(, "qd": [0], "qdd": [0]})";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"{\"q\": [1],\n\"qdd\": [0]}",
       "1: error: argument 'qd' of inverse_dynamics is missing: joint velocities (rad/s, m/s) [missing-argument]" +
           list},
      {"{\"q\": [1]\n, \"tau\": [1]" + others,
       "2: error: 'tau' is not an argument of inverse_dynamics [unknown-argument]" + list},
      {"{\"gravty\": [1]" + others,
       "1: error: 'gravty' is not an argument of inverse_dynamics [unknown-argument]\nhint: did you mean 'gravity'?" +
           list},
      {"{\"parameters\": {}" + others,
       "1: error: 'parameters' is not an argument of inverse_dynamics [unknown-argument]" + list},
      {"{\"q\": [1, 2]" + others,
       "1: error: 'q' must be an array of 1 number, not an array of 2 numbers [wrong-shape]"},
      {"\n{\"q\": 1" + others, "2: error: 'q' must be an array of 1 number, not the number 1 [wrong-shape]"},
      {"{\"q\":\n[\n\"a\"\n]" + others,
       "3: error: 'q' must be an array of 1 number, but [0] is the string \"a\" [wrong-shape]"},
      {"{\"q\": [[1]]" + others,
       "1: error: 'q' must be an array of 1 number, but [0] is an array of 1 number [wrong-shape]"},
      {"{\"q\": [null]" + others, "1: error: 'q' must be an array of 1 number, but [0] is null [wrong-shape]"},
      {"{\"q\": {}" + others, "1: error: 'q' must be an array of 1 number, not an object [wrong-shape]"},
      {"{\"q\": [1], \"external\": [1]" + others,
       "1: error: 'external' must be an object of name: array of 6 numbers, not an array of 1 number [wrong-shape]"},
      {"{\"q\": [1], \"external\": {\"rood\": [0,0,0,0,0,0]}" + others,
       "1: error: 'external' has no element 'rood'; its elements are base, rod [unknown-element]\nhint: did you mean "
       "'rod'?"},
      {"{\"q\": [1], \"external\": {\"rod\": [0]}" + others,
       "1: error: 'external.rod' must be an array of 6 numbers, not an array of 1 number [wrong-shape]"},
      {"{\"q\": [1],\n\"q\": [2]" + others, "2: error: 'q' is given twice [duplicate-key]"},
      {"{\"q\": [1], \"external\": {\"rod\": [0,0,0,0,0,0],\n\"rod\": 1}" + others,
       "2: error: 'rod' is given twice [duplicate-key]"},
      {"{\"q\": [\n1e999]" + others, "2: error: the number 1e999 is beyond the range of double [number-overflow]"},
      {"{\"q\": [NaN]" + others,
       "1: error: syntax error while parsing value - invalid literal; last read: '\"q\": [N' "
       "[json-syntax]\nhint: JSON has neither NaN nor infinity"},
      {"",
       "1: error: expected an object, such as {\"q\": [0.1]}, found the end of the input [json-syntax]\nhint: a "
       "function without arguments takes {}"},
      {"[1]",
       "1: error: expected an object, such as {\"q\": [0.1]}, found '1' [json-syntax]\nhint: a function without "
       "arguments takes {}"},
      {"{\"q\": " + std::string(20, '['), "1: error: values are nested deeper than 16 levels [too-deep]"}};
  for (const auto& [input, expected] : cases) {
    const Outcome result = run("inverse_dynamics", input);
    EXPECT_EQ(result.status, 1) << input;
    EXPECT_EQ(result.output, "") << input;
    EXPECT_EQ(result.errors, "<standard input>:" + expected + "\n") << input;
  }
}

TEST_F(Eval, SyntaxErrorsNameTheLine) {
  for (const char* input :
       {"{\"q\": [0]\n\"qd\"", "\n{\"q\": [0}", "\n{", "\n{\"q\" [0]}", "{\"q\": [0]}\n}", "\n[{\"q\": [0]}",
        "[{\"q\": [0]}\n{\"q\": [0]}]"}) {
    const Outcome syntax = run("gravity_forces", input);
    EXPECT_EQ(syntax.status, 1) << input;
    EXPECT_NE(syntax.errors.find("[json-syntax]"), std::string::npos) << input << syntax.errors;
  }
  EXPECT_NE(run("gravity_forces", "\n\n{\"q\": [0}").errors.find("<standard input>:3: error: "), std::string::npos);
}

TEST_F(Eval, UnknownFunctions) {
  const Outcome typo = run("inverse_dynamic", "{}");
  EXPECT_EQ(typo.status, 2);
  EXPECT_EQ(
      typo.errors,
      "robcogen: error: robot 'Pendulum' has no function 'inverse_dynamic' [unknown-function]\n"
      "hint: did you mean 'inverse_dynamics'?\n");
  const Outcome frame = run("jacobians.fr_base_J_tipp", "{}");
  EXPECT_EQ(frame.status, 2);
  EXPECT_NE(frame.errors.find("[unknown-function]"), std::string::npos) << frame.errors;
  const Outcome other = run("something_else_entirely", "{}");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.errors.find("hint: 'robcogen ops " + model_.string() + "' lists them"), std::string::npos)
      << other.errors;
}

// A value that JSON cannot represent is an error, not null.
TEST_F(Eval, ResultsThatAreNotFinite) {
  const Outcome overflow = run("kinetic_energy", "{\"q\": [0], \"qd\": [1]}\n{\"q\": [0], \"qd\": [1e200]}\n{}\n");
  EXPECT_EQ(overflow.status, 1);
  EXPECT_EQ(overflow.output, "{\"T\": [0.25]}\n");
  EXPECT_EQ(
      overflow.errors,
      "<standard input>:2: error: result T[0] of kinetic_energy is inf, which JSON cannot represent "
      "[result-not-finite]\n");
}

// There is one line of results for each state, in any layout; states after an error are not evaluated.
TEST_F(Eval, ManyStates) {
  const std::string expected =
      run("gravity_forces", "{\"q\": [0.1]}").output + run("gravity_forces", "{\"q\": [0.2]}").output;
  for (const char* input :
       {"{\"q\": [0.1]}\n{\"q\": [0.2]}\n", "{\"q\": [0.1]}{\"q\": [0.2]}", "[{\"q\": [0.1]}, {\"q\": [0.2]}]",
        " [\n{\"q\":\n[0.1]},\r\n {\"q\": [0.2]}\n]\n\n", "\n\n{\"q\":\n[0.1]}\n\n{\"q\": [0.2]}"}) {
    const Outcome result = run("gravity_forces", input);
    EXPECT_EQ(result.status, 0) << input << result.errors;
    EXPECT_EQ(result.output, expected) << input;
  }
  const Outcome none = run("gravity_forces", "[]");
  EXPECT_EQ(none.status, 0);
  EXPECT_EQ(none.output, "");
  const Outcome stopped = run("gravity_forces", "{\"q\": [0.1]}\n{\"q\": [0.2]}\n{\"q\": 0.3}\n{\"q\": [0.4]}\n");
  EXPECT_EQ(stopped.status, 1);
  EXPECT_EQ(stopped.output, expected);
  EXPECT_EQ(
      stopped.errors,
      "<standard input>:3: error: 'q' must be an array of 1 number, not the number 0.3 [wrong-shape]\n");
}

// A program waits for each result before it writes the next state.
TEST_F(Eval, AnswersEachStateAtOnce) {
  const std::string tool = "'" ROBCOGEN_TOOL "' eval " + quoted(model_) + " gravity_forces";
  const std::string script = "coproc tool { " + tool +
                             "; }; for q in 0 1; do echo \"{\\\"q\\\": [$q]}\" >&${tool[1]}; "
                             "read -t 20 line <&${tool[0]} || exit 9; done; exec {tool[1]}>&-; wait";
  write_text(scratch_.path / "script", script);
  EXPECT_EQ(std::system(("bash " + quoted(scratch_.path / "script")).c_str()), 0);
}

TEST_F(Eval, QuietLeavesErrorsOnly) {
  const auto model = scratch_.path / "arm.urdf";
  const std::string text = R"(<robot name="arm"><link name="base"/><link name="l"><visual/>
    <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
    <joint name="j" type="continuous"><parent link="base"/><child link="l"/></joint></robot>)";
  write_text(model, text);
  const std::string arguments = "eval " + quoted(model) + " gravity_forces";
  const Outcome loud = run_tool(arguments, "{\"q\": [0]}"), quiet = run_tool(arguments + " --quiet", "{\"q\": [0]}");
  EXPECT_NE(loud.errors, "");
  EXPECT_EQ(quiet.errors, "");
  EXPECT_EQ(quiet.output, loud.output);
  EXPECT_EQ(quiet.status, 0);
  write_text(model, text.substr(0, text.size() - 8));
  EXPECT_NE(run_tool(arguments + " --quiet", "{\"q\": [0]}").errors.find("error: "), std::string::npos);
}

// This includes functions that take gravity in all overloads.
TEST_F(Eval, GravityMayBeLeftOutWithAFixedBase) {
  json state = {{"q", {0.1}}, {"qd", {0.2}}, {"qdd", {0.3}}};
  const json without = eval("base_regressor_any_gravity", state);
  state["gravity"] = {0, 0, -9.81};
  EXPECT_EQ(eval("base_regressor_any_gravity", state), without);
}

// With a floating base, gravity says how the base is oriented.
TEST(EvalOfFloatingBase, GravityIsRequired) {
  const std::string arguments = "eval " + quoted(robot("quadruped")) + " gravity_forces";
  const json zeros = {{"q", std::vector<double>(12, 0.0)}};
  const Outcome missing = run_tool(arguments, zeros.dump());
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(
      missing.errors.find("argument 'gravity' of gravity_forces is missing: gravity (m/s^2) in base coordinates, "
                          "required because it depends on the orientation of the floating base [missing-argument]"),
      std::string::npos)
      << missing.errors;
  json given = zeros;
  given["gravity"] = {0, 0, -9.81};
  EXPECT_EQ(run_tool(arguments, given.dump()).status, 0);
}

// Returns a state with every argument that the message about an empty state lists.
json state_of(const std::string& message) {
  json state = json::object();
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("; optional") != std::string::npos) continue;
    if (const auto square = whole_match(line, "  (\\w+): array of (\\d+) rows? of .*")) {
      const std::size_t n = std::stoul((*square)[2]);
      state[(*square)[1]] = std::vector<std::vector<double>>(n, std::vector<double>(n, 1.0));
    } else if (const auto vector = whole_match(line, "  (\\w+): array of (\\d+) numbers?.*")) {
      state[(*vector)[1]] = std::vector<double>(std::stoul((*vector)[2]), 0.5);
    } else if (line.find("  variables: ") == 0) {
      std::istringstream names(line.substr(line.find('(') + 1, line.find(')') - line.find('(') - 1));
      for (std::string name; std::getline(names >> std::ws, name, ',');) state["variables"][name] = 0.5;
    }
  }
  return state;
}

// Every function that `ops` lists can be evaluated with exactly the arguments that its own message asks for. Each takes
// two processes.
TEST(EvalOfEveryFunction, ThatOpsLists) {
  const std::filesystem::path euler = std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / "euler" / "euler.motdsl";
  std::vector<std::filesystem::path> models = {robot("hyl"), euler};
  if (ROBCOGEN_TEST_EVERYTHING) models.push_back(robot("hyl_parametric"));
  const std::size_t stride = ROBCOGEN_TEST_EVERYTHING ? 1 : 15;  // two processes each
  for (const std::filesystem::path& model : models) {
    const Outcome ops = run_tool("ops --json --effort 0 " + quoted(model));
    ASSERT_EQ(ops.status, 0) << ops.errors;
    const json functions = json::parse(ops.output)["functions"];
    for (std::size_t k = 0; k < functions.size(); k += stride) {
      const std::string name = functions[k]["name"];
      const std::string arguments = "eval --quiet " + quoted(model) + " " + name;
      const Outcome empty = run_tool(arguments, "{}");
      if (empty.status == 0) continue;  // the function is constant
      const Outcome run = run_tool(arguments, state_of(empty.errors).dump());
      EXPECT_EQ(run.status, 0) << name << "\n" << run.errors;
      EXPECT_TRUE(json::accept(run.output)) << name;
    }
  }
}

// The Jacobian times the velocity is the frame's velocity, and its derivative times the velocity is the bias
// acceleration. No list of desired transforms names these frames.
TEST_F(Eval, VelocitiesAndAccelerationsAgreeWithJacobians) {
  const json state = {{"q", {0.3}}, {"qd", {0.7}}};
  // Returns the first column of the only result.
  const auto column = [&](const std::string& function) {
    json arguments = state;
    if (function.find("_J_") != std::string::npos) arguments.erase("qd");
    std::vector<double> values;
    const json result = eval(function, arguments);
    for (const json& row : result.front()) values.push_back(row.is_array() ? row[0] : row);
    return values;
  };
  const std::vector<double> spatial = column("jacobians.spatial.fr_base_J_tip");
  const std::vector<double> twist = column("velocities.fr_base_V_tip");
  const std::vector<double> J = column("jacobians.fr_base_J_tip"), Jd = column("jacobians.fr_base_Jd_tip");
  const std::vector<double> bias = column("jacobians.fr_base_Jd_qd_tip");
  ASSERT_EQ(twist.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(twist[i], spatial[i] * 0.7, kRounding * 10);
    EXPECT_NEAR(bias[i], Jd[i] * 0.7, kRounding * 10);
  }
  EXPECT_NEAR(J[5], -0.5 * std::cos(0.3), kRounding * 10);
  EXPECT_NEAR(Jd[5], 0.5 * std::sin(0.3) * 0.7, kRounding * 10);
}

// The same rod on a spherical joint, whose frame has the hinge's orientation.
TEST_F(Eval, QuaternionsOfSphericalJoints) {
  write_text(model_, replaced(kPendulum, "r_joint", "s_joint"));
  // Turned by a about z, the joint takes the hinge's moment at this angle about z; its moments about x and y are zero.
  const double a = 0.3;
  json state = {{"q", {std::cos(a / 2), 0, 0, std::sin(a / 2)}}, {"qd", {0, 0, 7}}, {"qdd", {0, 0, 1.5}}};
  const json tau = eval("inverse_dynamics", state)["tau"];
  ASSERT_EQ(tau.size(), 3);
  EXPECT_NEAR(tau[0], 0, kRounding * 10);
  EXPECT_NEAR(tau[1], 0, kRounding * 10);
  EXPECT_NEAR(tau[2], 2.0 * 0.25 * 1.5 - 2.0 * 9.81 * 0.5 * std::cos(a), kRounding * 10);
  // Quaternions are normalised if their norm is within 1e-6 of 1.
  json longer = state;
  for (auto& e : longer["q"]) e = static_cast<double>(e) * (1 + 5e-7);
  EXPECT_NEAR(eval("inverse_dynamics", longer)["tau"][2], tau[2], kRounding * 10);
  for (auto& e : longer["q"]) e = static_cast<double>(e) * (1 + 1e-6);
  const Outcome refused = run("inverse_dynamics", longer.dump());
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.errors.find("<standard input>:1: error: 'q': elements 0 to 3 (hinge_w"), std::string::npos)
      << refused.errors;
  EXPECT_NE(refused.errors.find("[quaternion-norm]"), std::string::npos);
  // Derivatives are with respect to turns about the child's axes: three columns.
  EXPECT_EQ(eval("inverse_dynamics_derivatives", state)["d_q"][0].size(), 3);
}

TEST_F(Eval, PrimitivesHaveNoRotationsByQuaternions) {
  write_text(model_, replaced(kPendulum, "r_joint", "s_joint"));
  const Outcome refused = run_tool(
      "generate " + quoted(model_) + " -o " + quoted(scratch_.path / "out") +
          " --name p --language matlab --primitives left",
      "");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.errors.find("[spherical-joint]"), std::string::npos) << refused.errors;
  EXPECT_FALSE(std::filesystem::exists(scratch_.path / "out"));
}

}  // namespace
}  // namespace robcogen::test::eval_test
