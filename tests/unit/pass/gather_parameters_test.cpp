// Text in, text out: values that depend only on parameters fold like constants.
#include "pass/gather_parameters.h"

#include "symbolic/cost.h"
#include "symbolic/programs.h"

namespace robcogen::pass::gather_parameters_test {
namespace {

// k: parameters; x: variables.
symbolic::Program parametric(const std::string& statements) {
  return test::program(
      "program test\n"
      "input k parameters a b c\n"
      "input x value 0 1\n"
      "output out value 1 1\n"
      "section hip link hip\n"
      "in 0\n" +
      statements);
}

// Returns the statements only.
std::string gathered(const std::string& statements) {
  const std::string text = symbolic::print(gather_parameters(parametric(statements)));
  return text.substr(text.find("in 0\n") + 5);
}

TEST(GatherParameters, FactorsMultiply) {
  EXPECT_EQ(
      gathered("let y = k[0] * x[0]\nlet z = y * k[1]\nreturn out z\n"),
      "tmp hip_t0 = k[0] * k[1]\nlet z = x[0] * hip_t0\nreturn out z\n");
}

TEST(GatherParameters, FactorsOfOneValueAdd) {
  EXPECT_EQ(
      gathered("let y = k[0] * x[0]\nlet z = x[0] * k[1]\nlet w = y - z\nreturn out w\n"),
      "tmp hip_t0 = k[0] - k[1]\nlet w = x[0] * hip_t0\nreturn out w\n");
  EXPECT_EQ(
      gathered("let y = k[0] * x[0]\nlet w = x[0] - y\nreturn out w\n"),
      "tmp hip_t0 = 1.0 - k[0]\nlet w = x[0] * hip_t0\nreturn out w\n");
}

TEST(GatherParameters, SummandsAdd) {
  EXPECT_EQ(
      gathered("let y = x[0] - k[0]\nlet z = k[1] - y\nreturn out z\n"),
      "tmp hip_t0 = k[0] + k[1]\nlet z_neg = x[0] - hip_t0\nreturn out -z_neg\n");
}

TEST(GatherParameters, ProductsOfTwoVariablesStay) {
  const std::string statements =
      "let p = k[0] * k[1]\n"
      "let y = p * x[0]\n"
      "let z = y * x[1]\n"
      "let w = 2 * z\n"
      "return out w\n";
  EXPECT_EQ(symbolic::cost(gather_parameters(parametric(statements))).mul, 4);
}

TEST(GatherParameters, ChangesNoResult) {
  const symbolic::Program program = parametric(
      "let u = sin k[2]\n"
      "let y = k[0] * x[0]\n"
      "let z = y - k[1]\n"
      "let v = u * z\n"
      "let w = v + u\n"
      "let t = w * x[1]\n"
      "let r = x[1] * k[0]\n"
      "let s = t - r\n"
      "return out s\n");
  const symbolic::Arrays<double> inputs = {{"k", {0.7, -1.3, 0.4}}, {"x", {1.9, -0.6}}};
  EXPECT_NEAR(
      symbolic::interpret<double>(gather_parameters(program), inputs).at("out")[0],
      symbolic::interpret<double>(program, inputs).at("out")[0], 1e-15);
}

}  // namespace
}  // namespace robcogen::pass::gather_parameters_test
