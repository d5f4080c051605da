// The canonical form: text in, text out. The tests in symbolic cover the folding rules themselves.
#include <gtest/gtest.h>

#include "pass/passes.h"
#include "symbolic/programs.h"

namespace robcogen::pass::canonical_test {
namespace {

std::string canonical_text(const std::string& text) {
  const symbolic::Program p = canonical(test::program(text));
  EXPECT_EQ(verify(p), "");
  return print(p);
}

TEST(Canonical, FoldsAndKeepsNamesAndSections) {
  EXPECT_EQ(
      canonical_text("program test\n"
                     "input q joint_position A B\n"
                     "output tau joint_force 3 1\n"
                     "section hip link hip\n"
                     "section knee link knee\n"
                     "in 0\n"
                     "tmp zero = q[0] * 0.0\n"
                     "let sum = q[0] + q[1]\n"
                     "tmp angle = pi:1:2 + zero\n"
                     "in 1\n"
                     "tmp c = cos angle\n"
                     "let wz = c + sum\n"
                     "tmp double = wz + wz\n"
                     "let force = 0.5 * double\n"
                     "let moment = double * sum\n"
                     "return tau force -moment c\n"),
      "program test\n"
      "input q joint_position A B\n"
      "output tau joint_force 3 1\n"
      "section hip link hip\n"
      "section knee link knee\n"
      "in 0\n"
      "let sum = q[0] + q[1]\n"
      "in 1\n"
      "tmp knee_t0 = sum * 2.0\n"
      "let moment = sum * knee_t0\n"
      "return tau sum -moment 0.0\n");
}

TEST(Canonical, MergesEqualStatements) {
  EXPECT_EQ(
      canonical_text(
          test::head() + "in 0\n"
                         "let x = a[0] - a[1]\n"
                         "let y = a[1] - a[0]\n"
                         "let z = x * y\n"
                         "return out z\n"),
      "program test\n"
      "input a value 0 1 2 3\n"
      "output out value 1 1\n"
      "section hip link hip\n"
      "in 0\n"
      "let x = a[0] - a[1]\n"
      "let z_neg = x * x\n"
      "return out -z_neg\n");
}

// The cosine of an angle that cancels is the constant one, whichever statement gives the zero.
TEST(Canonical, OfWhatCancels) {
  EXPECT_EQ(
      canonical_text(test::head(2) + "in 0\nlet x = a[0] - a[0]\nlet c = cos x\nlet s = sin x\nreturn out c s\n"),
      "program test\n"
      "input a value 0 1 2 3\n"
      "output out value 2 1\n"
      "return out 1.0 0.0\n");
}

// A second run finds nothing more. (It may change `x * y` to `y * x`, because the operand that was made first comes
// first.)
TEST(Canonical, IsIdempotent) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    const symbolic::Program once = canonical(test::RandomPrograms(seed).make()), twice = canonical(once);
    EXPECT_EQ(twice.statements.size(), once.statements.size()) << "seed " << seed << print(once) << print(twice);
    EXPECT_LE(once.statements.size(), test::RandomPrograms(seed).make().statements.size());
  }
}

}  // namespace
}  // namespace robcogen::pass::canonical_test
