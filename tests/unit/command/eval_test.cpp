// `robcogen eval` against closed forms, and its messages.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "run_tool.h"

namespace robcogen::test {
namespace {

using nlohmann::json;

constexpr double kRounding = 1e-14;

// A point mass of 2 kg on a massless rod of 0.5 m; the joint's z axis is the base's y axis, the rod along x at q = 0.
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
  // Turning by q about +y lowers the tip: gravity pulls the joint along, so holding it takes -m g l cos q.
  const double expected = 2.0 * 0.25 * qdd - 2.0 * 9.81 * 0.5 * std::cos(q);
  EXPECT_NEAR(
      eval("inverse_dynamics", {{"q", {q}}, {"qd", {7.0}}, {"qdd", {qdd}}})["tau"][0], expected, kRounding * 10);
}

TEST_F(Eval, AbsentArgumentsAreZeroAndGravityIsStandard) {
  EXPECT_NEAR(eval("inverse_dynamics", json::object())["tau"][0], -9.81, kRounding * 10);
  EXPECT_EQ(eval("inverse_dynamics", {{"gravity", {0, 0, 0}}})["tau"][0], 0.0);
}

TEST_F(Eval, ForwardDynamicsAndExternalWrench) {
  // 3 N m about the link's z axis on the link, no gravity: like a joint force.
  const json result =
      eval("forward_dynamics", {{"tau", {1.0}}, {"gravity", {0, 0, 0}}, {"external", {{"rod", {0, 0, 3, 0, 0, 0}}}}});
  EXPECT_NEAR(result["qdd"][0], 4.0 / 0.5, kRounding * 10);
}

TEST_F(Eval, MatricesAreNestedRows) {
  EXPECT_EQ(eval("joint_space_inertia", {{"q", {0.7}}})["H"], json::parse("[[0.5]]"));
  const json x = eval("transforms.homogeneous.fr_base_X_tip", {{"q", {0.0}}})["X"];
  const json expected = json::parse("[[1, 0, 0, 0.5], [0, 0, 1, 0], [0, -1, 0, 1], [0, 0, 0, 1]]");
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(x[r][c].get<double>(), expected[r][c].get<double>(), kRounding);
  const json j = eval("jacobians.fr_base_J_tip", {{"q", {0.0}}})["J"];
  ASSERT_EQ(j.size(), 6U);
  const double column[] = {0, 1, 0, 0, 0, -0.5};
  for (int r = 0; r < 6; ++r) EXPECT_NEAR(j[r][0].get<double>(), column[r], kRounding);
}

// What one function returns is what the next one takes.
TEST_F(Eval, FactorOfTheInertiaMatrix) {
  json factor = eval("joint_space_inertia_factor", {{"q", {0.7}}});
  EXPECT_NEAR(factor["L"][0][0], std::sqrt(0.5), kRounding);
  factor["x"] = {3.0};
  EXPECT_NEAR(eval("inertia_factor.solve", factor)["y"][0], 6.0, kRounding * 10);
  EXPECT_NEAR(eval("inertia_factor.inverse", factor)["inverse"][0][0], 2.0, kRounding * 10);
  for (const char* wrong : {"{\"L\": 1}", "{\"L\": [1]}", "{\"L\": [[1, 2]]}", "{\"L\": [[1], [2]]}"})
    EXPECT_EQ(run("inertia_factor.solve", wrong).status, 1) << wrong;
}

TEST_F(Eval, SeventeenDigitsReadBackExactly) {
  const json result = eval("gravity_forces", {{"q", {0.1}}});
  const double value = result["tau"][0];
  EXPECT_NEAR(value, -9.81 * std::cos(0.1), kRounding * 10);
  EXPECT_EQ(json::parse(json(value).dump()).get<double>(), value);
}

TEST_F(Eval, RefusesWhatMakesNoSense) {
  for (const char* input :
       {"", "[1]", "{\"q\": 1}", "{\"q\": [1, 2]}", "{\"q\": [\"a\"]}", "{\"Q\": [1]}", "{\"gravity\": [1]}",
        "{\"external\": {\"rood\": [0,0,0,0,0,0]}}", "{\"external\": {\"rod\": [0]}}", "{\"parameters\": {\"x\": 1}}",
        "{\"q\": [1}"}) {
    const Outcome result = run("inverse_dynamics", input);
    EXPECT_EQ(result.status, 1) << input;
    EXPECT_NE(result.errors.find("error: "), std::string::npos) << input;
    EXPECT_EQ(result.output, "") << input;
  }
  const Outcome typo = run("inverse_dynamic", "{}");
  EXPECT_EQ(typo.status, 2);
  EXPECT_NE(typo.errors.find("did you mean 'inverse_dynamics'?"), std::string::npos) << typo.errors;
  EXPECT_EQ(run("transforms.homogeneous.fr_base_X_nothing", "{}").status, 2);
}

}  // namespace
}  // namespace robcogen::test
