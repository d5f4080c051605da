// Documents of motions and of transforms in every subcommand.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "run_tool.h"

namespace robcogen::test::transforms_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kRounding = 1e-15;

class Transforms : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) {
    write_text(scratch_.path / name, text);
    return quoted(scratch_.path / name);
  }
  std::string motions() {
    return file(
        "arm.motdsl",
        "Model Arm Params sizes { reach } Convention = local base -> elbow : rotz(shoulder) trx(sizes.reach) "
        "[upper] elbow -> hand : roty(bend) trx(p:palm[0.1])");
  }
  // Generates code and returns the text of one file.
  std::string generated(const std::string& arguments, const std::string& path) {
    const Outcome run = run_tool("generate " + arguments + " --name arm -o " + quoted(scratch_.path));
    EXPECT_EQ(run.status, 0) << run.errors;
    return read_text(scratch_.path / "arm" / path);
  }

  Scratch scratch_{"transforms"};
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(Transforms, FunctionsTakeVariablesByNameBehindTheParameters) {
  const std::string text = generated(motions(), "arm.h");
  EXPECT_TRUE(contains(text, "\nMatrix<4, 4> upper(const Parameters& parameters, Scalar shoulder) noexcept;")) << text;
  EXPECT_TRUE(contains(text, "\nMatrix<6, 6> hand_X_elbow(const Parameters& parameters, Scalar bend) noexcept;"));
  // A user's name belongs to the transform of the motion, not to its inverse.
  EXPECT_TRUE(contains(text, "\nMatrix<4, 4> elbow_X_base("));
  const std::string types = read_text(scratch_.path / "arm" / "types.h");
  EXPECT_TRUE(contains(types, "Scalar palm = Scalar(0.1);")) << types;
  EXPECT_TRUE(contains(types, "Scalar reach = std::numeric_limits<Scalar>::quiet_NaN();")) << types;
}

TEST_F(Transforms, OfAListCanBeBetweenAnyConnectedFrames) {
  const std::string list = file("arm.dtdsl", "Model Arm Frames { ^base, hand } Transforms { base=^base, target=hand }");
  const std::string text = generated(motions() + " --desired " + list, "arm.h");
  EXPECT_TRUE(contains(text, "base_X_hand(const Parameters& parameters, Scalar shoulder, Scalar bend)")) << text;
  EXPECT_FALSE(contains(text, "upper("));

  const std::string transforms = file(
      "arm.ctdsl",
      "Model Arm MovedFramePos = right {base}_X_{elbow} = Rz(shoulder) Tx(0.3) {elbow}_X_{hand} = Ry(bend)");
  EXPECT_TRUE(
      contains(generated(transforms + " --desired " + list, "arm.h"), "base_X_hand(Scalar shoulder, Scalar bend)"));
  EXPECT_TRUE(contains(generated(transforms, "arm.h"), "elbow_X_hand(Scalar bend)"));
}

TEST_F(Transforms, NamesThatTheCodeNeedsGiveWay) {
  const std::string text = generated(
      file("arm.motdsl", "Model Arm Convention = local A -> B : rotx(X) roty(Scalar) rotz(double) trx(kernel)"),
      "arm.h");
  EXPECT_TRUE(contains(text, "A_X_B(Scalar X_2, Scalar Scalar_2, Scalar double_, Scalar kernel_2)")) << text;
}

TEST_F(Transforms, NoTwoTransformsMayHaveOneName) {
  const std::string document = file(
      "arm.ctdsl",
      "Model Arm MovedFramePos = right {A}_X_{B} = Rz(q) [back] {C}_X_{B} = Rz(q) [A_X_C] {A}_X_{C} = Rx(q)");
  const Outcome run = run_tool("generate " + document + " --name arm -o " + quoted(scratch_.path));
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.errors, "two transforms would be called 'A_X_C'")) << run.errors;
  EXPECT_TRUE(contains(run.errors, "[duplicate-name]"));
  EXPECT_FALSE(fs::exists(scratch_.path / "arm"));
}

TEST_F(Transforms, HaveNoAlgorithmsOfRobots) {
  const Outcome run =
      run_tool("generate " + motions() + " --algorithms jacobians --name arm -o " + quoted(scratch_.path));
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(contains(run.errors, "--algorithms jacobians applies to robots")) << run.errors;
  EXPECT_EQ(run_tool("ops --algorithms jacobians -- " + motions()).status, 2);
  EXPECT_EQ(run_tool("ops --floating-base " + motions()).status, 2);
}

TEST_F(Transforms, HashesSayNothingOfCommentsAndLayout) {
  const auto model_header = [&](const std::string& text) { return generated(file("arm.motdsl", text), "model.h"); };
  const std::string plain = model_header("Model Arm Convention = local A -> B : rotx(q)");
  EXPECT_EQ(model_header("// Arm.\nModel Arm\nConvention = currentFrame\n\nA->B: rotx( q )"), plain);
  EXPECT_NE(model_header("Model Arm Convention = local A -> B : rotx(p)"), plain);
}

TEST_F(Transforms, AreCheckedWithTheirLists) {
  EXPECT_EQ(run_tool("check " + motions()).status, 0);
  const std::string list = file("arm.dtdsl", "Model Arm Frames { ^base, hnad } Transforms { base=^base, target=hnad }");
  const Outcome lenient = run_tool("check " + motions() + " " + list);
  EXPECT_EQ(lenient.status, 0);
  EXPECT_TRUE(contains(lenient.errors, "did you mean 'hand'?")) << lenient.errors;
  EXPECT_EQ(run_tool("check --strict " + motions() + " " + list).status, 1);
  const Outcome loop = run_tool(
      "check " + file("loop.motdsl", "Model L Convention = local A -> B : rotx(q) B -> C : rotx(q) C -> A : rotx(q)"));
  EXPECT_EQ(loop.status, 1);
  EXPECT_TRUE(contains(loop.errors, "loop.motdsl:1:")) << loop.errors;
  EXPECT_TRUE(contains(loop.errors, "[motion-loop]"));
}

TEST_F(Transforms, ArePrintedAsDocumentsAndAsPrograms) {
  const Outcome document = run_tool("print " + motions());
  EXPECT_EQ(document.status, 0);
  EXPECT_TRUE(contains(document.output, "base -> elbow : rotz(shoulder) trx(sizes.reach) [upper]\n"))
      << document.output;
  const std::string transforms = file("arm.ctdsl", "Model Arm TransformedFramePos = left {A} _X_ {B} = Rz(q)");
  EXPECT_TRUE(contains(run_tool("print " + transforms).output, "{A}_X_{B} = Rz(q)\n"));
  const Outcome program = run_tool("print --program homogeneous_upper " + motions());
  EXPECT_EQ(program.output.find("program homogeneous_upper\ninput parameters parameters reach palm\n"), 0u)
      << program.output;
  EXPECT_EQ(run_tool("print --program homogeneous_lower " + motions()).status, 2);
}

TEST_F(Transforms, AreCounted) {
  const json report = json::parse(run_tool("ops --json " + motions()).output);
  EXPECT_EQ(report["model"], "Arm");
  EXPECT_EQ(report["functions"].size(), 12u);
  EXPECT_EQ(report["functions"][0]["name"], "transforms.homogeneous.upper");
  EXPECT_EQ(report["functions"][0]["sincos"], 1);
}

TEST_F(Transforms, AreEvaluated) {
  const std::string eval = "eval " + motions() + " transforms.homogeneous.";
  const Outcome run = run_tool(eval + "upper", R"({"variables": {"shoulder": 0.3}, "parameters": {"reach": 2}})");
  ASSERT_EQ(run.status, 0) << run.errors;
  const json X = json::parse(run.output)["X"];
  EXPECT_NEAR(X[0][3].get<double>(), 2 * std::cos(0.3), kRounding * 2);
  EXPECT_NEAR(X[1][0].get<double>(), std::sin(0.3), kRounding);
  // Defaults are used.
  const Outcome still = run_tool(eval + "elbow_X_hand", R"({"variables": {"bend": 0}, "parameters": {"reach": 2}})");
  ASSERT_EQ(still.status, 0) << still.errors;
  EXPECT_EQ(json::parse(still.output)["X"][0][3], 0.1);
  for (const char* wrong :
       {"{}", R"({"variables": {}, "parameters": {"reach": 2}})", R"({"variables": {"shoulder": 0.3}})",
        R"({"variables": {"sholder": 1}})", R"({"q": [1]})", R"({"variables": [1]})",
        R"({"variables": {"shoulder": 0.3, "bend": 0}, "parameters": {"reach": 2}})",
        R"({"variables": {"shoulder": "a"}, "parameters": {"reach": 2}})"}) {
    const Outcome refused = run_tool(eval + "upper", wrong);
    EXPECT_EQ(refused.status, 1) << wrong;
    EXPECT_TRUE(contains(refused.errors, "error: ")) << refused.errors;
  }
  const Outcome unknown = run_tool(eval + "uper", "{}");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(contains(unknown.errors, "did you mean 'transforms.homogeneous.upper'?")) << unknown.errors;
}

}  // namespace
}  // namespace robcogen::test::transforms_test
