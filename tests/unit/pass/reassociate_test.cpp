// Reassociation: text in, text out; sums fuse with products.
#include <gtest/gtest.h>

#include "pass/passes.h"
#include "symbolic/cost.h"
#include "symbolic/programs.h"

namespace robcogen::pass::reassociate_test {
namespace {

using symbolic::Program;

std::string reassociated(const std::string& statements, int outputs = 1) {
  const Program p = reassociate(test::small_program(statements, outputs));
  EXPECT_EQ(verify(p), "");
  std::string text = print(p);
  return text.substr(text.find("in 0\n"));
}

int instructions(const Program& p) {
  return symbolic::cost(p).instructions;
}

// x + (m + n): the inner sum fuses with one product, the outer sum with none. (x + m) + n fuses with both.
TEST(Reassociate, BeginsAChainWithATermThatIsNoProduct) {
  const std::string statements =
      "in 0\n"
      "tmp m = a[0] * a[1]\n"
      "tmp n = a[2] * a[3]\n"
      "tmp inner = m + n\n"
      "tmp outer = a[0] + inner\n"
      "return out outer\n";
  EXPECT_EQ(
      reassociated(statements),
      "in 0\n"
      "tmp hip_t0 = a[0] * a[1]\n"
      "tmp hip_t1 = a[2] * a[3]\n"
      "tmp hip_t2 = a[0] + hip_t0\n"
      "tmp hip_t3 = hip_t1 + hip_t2\n"
      "return out hip_t3\n");
  EXPECT_EQ(instructions(test::small_program(statements)), 3);
  EXPECT_EQ(instructions(reassociate(test::small_program(statements))), 2);
}

TEST(Reassociate, SignsGoWithTheirTerms) {
  EXPECT_EQ(
      reassociated("in 0\n"
                   "tmp m = a[0] * a[1]\n"
                   "tmp n = a[2] * a[3]\n"
                   "tmp inner = m - n\n"
                   "tmp outer = a[0] - inner\n"
                   "return out outer\n"),
      "in 0\n"
      "tmp hip_t0 = a[0] * a[1]\n"
      "tmp hip_t1 = a[2] * a[3]\n"
      "tmp hip_t2 = a[0] - hip_t0\n"
      "tmp hip_t3 = hip_t1 + hip_t2\n"
      "return out hip_t3\n");
}

TEST(Reassociate, ANamedSumIsNotTakenApart) {
  const std::string statements =
      "in 0\n"
      "let m = a[0] * a[1]\n"
      "let n = a[2] * a[3]\n"
      "let inner = m + n\n"
      "let outer = a[0] + inner\n"
      "return out outer\n";
  EXPECT_EQ(reassociated(statements), statements);
}

// A product is fused into a sum when its factors are ready, so it goes before a sum that is ready only when the product
// would be.
TEST(Reassociate, AProductIsReadyWithItsFactors) {
  const Program before = test::small_program(
      "in 0\n"
      "let u = a[0] + a[1]\n"
      "tmp m = a[2] * a[3]\n"
      "tmp s = u + m\n"
      "let t = s + a[0]\n"
      "return out t u\n",
      2);
  EXPECT_EQ(symbolic::cost(before).critical_path, 4 + 2 * 4);
  EXPECT_EQ(symbolic::cost(reassociate(before)).critical_path, 4 + 4);
}

TEST(Reassociate, ASumThatIsReadTwiceIsNotTakenApart) {
  const std::string statements =
      "in 0\n"
      "let m = a[0] * a[1]\n"
      "let n = a[2] * a[3]\n"
      "tmp hip_t0 = m + n\n"
      "let outer = a[0] + hip_t0\n"
      "return out outer hip_t0\n";
  EXPECT_EQ(reassociated(statements, 2), statements);
}

// A balanced sum of many terms that are ready at once, in a program that has nothing else to do, stays unchanged: a
// chain would be several times as long.
TEST(Reassociate, KeepsASumWhoseChainWouldBeLate) {
  std::string statements = "in 0\n";
  for (int k = 0; k < 8; ++k)
    statements +=
        "let r" + std::to_string(k) + " = a[" + std::to_string(k % 4) + "] * " + std::to_string(k + 2) + ".5\n";
  for (int k = 0; k < 4; ++k)
    statements +=
        "tmp x" + std::to_string(k) + " = r" + std::to_string(2 * k) + " + r" + std::to_string(2 * k + 1) + "\n";
  statements += "tmp y0 = x0 + x1\ntmp y1 = x2 + x3\ntmp z = y0 + y1\nreturn out z\n";
  const Program before = test::small_program(statements), after = reassociate(before);
  EXPECT_EQ(symbolic::cost(before).critical_path, 4 + 3 * 4);
  EXPECT_LE(symbolic::cost(after).critical_path, symbolic::cost(before).critical_path);
}

// The purpose of reassociation: never more instructions, and fewer if a sum of products was badly grouped.
TEST(Reassociate, NeverAddsInstructions) {
  int fewer = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const Program before = canonical(test::RandomPrograms(seed).make()), after = reassociate(before);
    EXPECT_LE(instructions(after), instructions(before)) << "seed " << seed << "\n" << print(before) << print(after);
    fewer += instructions(after) < instructions(before);
  }
  EXPECT_GT(fewer, 5);
}

}  // namespace
}  // namespace robcogen::pass::reassociate_test
