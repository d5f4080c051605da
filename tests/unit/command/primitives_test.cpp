// The option --primitives: transforms as products of the user's own matrices.
#include <gtest/gtest.h>

#include "patterns.h"
#include "run_tool.h"

namespace robcogen::test::primitives_test {
namespace {

namespace fs = std::filesystem;

std::string product(const Scratch& scratch, const std::string& convention, const std::string& name) {
  const Outcome run = run_tool(
      "generate " + quoted(robot("hyl")) + " -o " + quoted(scratch.path) +
      " --name hyl --language matlab --algorithms transforms --frames '*' --primitives " + convention);
  EXPECT_EQ(run.status, 0) << run.errors;
  // Removes line breaks, which depend on the length of names.
  const std::string text = read_text(scratch.path / "matlab" / "+hyl" / "+transforms" / "+product" / (name + ".m"));
  return replaced(text, R"(( \.\.\.)?\n *%? *)", " ");
}

// The HyL of Fig. 9 of the paper: a slider; the hip is offset by 0.13 m and -0.08 m and turned by -PI/2 about x and
// PI/2 about z.
TEST(Primitives, AreInTheOrderOfTheDocumentOfTransforms) {
  const Scratch scratch("primitives");
  const std::string right = product(scratch, "right", "fr_base_X_fr_upperleg");
  EXPECT_NE(
      right.find("X = Tz(q(1)) * Ty(0.13) * Tz(-0.08) * Rx(-1.5707963267948966) * Rz(1.5707963267948966) * "
                 "Rz(q(2));"),
      std::string::npos)
      << right;
  EXPECT_NE(right.find("moved frame on the right"), std::string::npos);
  const std::string back = product(scratch, "right", "fr_upperleg_X_fr_base");
  EXPECT_NE(back.find("X = Rz(-q(2)) * Rz(-1.5707963267948966) * Rx(1.5707963267948966) *"), std::string::npos) << back;
  EXPECT_NE(back.find("Tz(0.08) * Ty(-0.13) * Tz(-q(1));"), std::string::npos) << back;
}

TEST(Primitives, OfTheOtherConventionHaveTheOtherSign) {
  const Scratch scratch("primitives-left");
  const std::string left = product(scratch, "left", "fr_base_X_fr_upperleg");
  EXPECT_NE(left.find("X = Tz(-q(1)) * Ty(-0.13) * Tz(0.08) * Rx(1.5707963267948966) *"), std::string::npos) << left;
  EXPECT_NE(left.find("moved frame on the left"), std::string::npos);
}

TEST(Primitives, ComeInMaximaToo) {
  const Scratch scratch("maxima-primitives");
  const std::string generate = "generate " + quoted(robot("hyl")) + " -o " + quoted(scratch.path) +
                               " --name hyl --namespace a --language maxima --algorithms transforms --frames '*'";
  ASSERT_EQ(run_tool(generate + " --primitives right").status, 0);
  const std::string text = read_text(scratch.path / "maxima" / "a_hyl.mac");
  EXPECT_NE(
      text.find("\na_hyl_product_fr_base_X_fr_upperleg(q) := block(\n"
                "  [q__1, q__2, q__3],\n"
                "  [q__1, q__2, q__3]: q,\n"
                "  Tz(q__1) . Ty(13/100) . Tz(-2/25) . Rx(-%pi/2) . Rz(%pi/2) . Rz(q__2))$\n"),
      std::string::npos)
      << text;
  EXPECT_EQ(text.find("inverse_dynamics"), std::string::npos);
  ASSERT_EQ(run_tool(generate).status, 0);
  EXPECT_EQ(read_text(scratch.path / "maxima" / "a_hyl.mac").find("product"), std::string::npos);
}

TEST(Primitives, AreNotPrintedUnlessAskedFor) {
  const Scratch scratch("no-primitives");
  const std::string generate =
      "generate " + quoted(robot("hyl")) + " -o " + quoted(scratch.path) + " --name hyl --language matlab --frames '*'";
  ASSERT_EQ(run_tool(generate + " --primitives left").status, 0);
  const fs::path folder = scratch.path / "matlab" / "+hyl" / "+transforms" / "+product";
  EXPECT_TRUE(fs::exists(folder / "fr_base_X_fr_foot.m"));
  // Files that are no longer generated are removed; other files stay.
  write_text(folder / "mine.m", "% mine\n");
  ASSERT_EQ(run_tool(generate).status, 0);
  EXPECT_FALSE(fs::exists(folder / "fr_base_X_fr_foot.m"));
  EXPECT_TRUE(fs::exists(folder / "mine.m"));
  EXPECT_TRUE(fs::exists(scratch.path / "matlab" / "+hyl" / "inverse_dynamics.m"));
}

}  // namespace
}  // namespace robcogen::test::primitives_test
