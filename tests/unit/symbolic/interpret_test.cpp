// Programs run without a compiler, in double and in long double.
#include "symbolic/interpret.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "programs.h"

namespace robcogen::symbolic::interpret_test {
namespace {

template <class Real>
Real run(const std::string& statement, const std::vector<Real>& a) {
  return interpret<Real>(test::small_program("let x = " + statement + "\nreturn out x\n"), {{"a", a}}).at("out").at(0);
}

template <class Real>
class Interpret : public testing::Test {};
using Reals = testing::Types<double, long double>;
TYPED_TEST_SUITE(Interpret, Reals);

TYPED_TEST(Interpret, EveryOperation) {
  using Real = TypeParam;
  const std::vector<Real> a = {Real(0.3L), Real(0.7L), Real(-2.0L), Real(5.0L)};
  EXPECT_EQ(run("a[0] + a[1]", a), a[0] + a[1]);
  EXPECT_EQ(run("a[0] - a[1]", a), a[0] - a[1]);
  EXPECT_EQ(run("a[0] * a[1]", a), a[0] * a[1]);
  EXPECT_EQ(run("a[0] / a[1]", a), a[0] / a[1]);
  EXPECT_EQ(run("sqrt a[1]", a), std::sqrt(a[1]));
  EXPECT_EQ(run("sin a[1]", a), std::sin(a[1]));
  EXPECT_EQ(run("cos a[1]", a), std::cos(a[1]));
  EXPECT_EQ(run("-a[0] - -a[2]", a), -a[0] + a[2]);
  EXPECT_EQ(run("sqrt -a[2]", a), std::sqrt(Real(2)));
  EXPECT_EQ(run("a[3] * -0.25", a), Real(-1.25));
}

// As in generated code, a literal is the nearest double, and a multiple of PI has the precision of the scalar.
TYPED_TEST(Interpret, Constants) {
  using Real = TypeParam;
  const std::vector<Real> a(4, Real(0));
  EXPECT_EQ(run("a[0] + 0.1", a), static_cast<Real>(0.1));
  EXPECT_EQ(run("a[0] + pi:1:1", a), std::acos(Real(-1)));
  const Real ulp = std::numeric_limits<Real>::epsilon();
  EXPECT_NEAR(static_cast<double>((run("sin pi:1:6", a) - Real(0.5)) / ulp), 0.0, 1.0);
  EXPECT_NEAR(static_cast<double>(run("cos pi:7:2", a) / ulp), 0.0, 8.0);
}

TYPED_TEST(Interpret, StatementsReadEarlierOnes) {
  using Real = TypeParam;
  const Program p = test::small_program(
      "let x = a[0] * a[1]\n"
      "let y = x + a[2]\n"
      "let z = y / x\n"
      "return out z -x a[3] 2.5\n",
      4);
  const auto out = interpret<Real>(p, {{"a", {Real(2), Real(3), Real(12), Real(9)}}}).at("out");
  EXPECT_EQ(out, (std::vector<Real>{Real(3), Real(-6), Real(9), Real(2.5)}));
}

const char* const kTwoArrays =
    "program test\n"
    "input q value x y\n"
    "input p value z\n"
    "output sum value 1 1\n"
    "output all value 3 1\n"
    "section t t\n"
    "in 0\n"
    "tmp t0 = q[0] + q[1]\n"
    "tmp t1 = t0 + p[0]\n"
    "return sum t1\n"
    "return all p[0] q[1] q[0]\n";

TYPED_TEST(Interpret, ArraysByName) {
  using Real = TypeParam;
  const auto results = interpret<Real>(test::program(kTwoArrays), {{"p", {Real(4)}}, {"q", {Real(1), Real(2)}}});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results.at("sum"), std::vector<Real>{Real(7)});
  EXPECT_EQ(results.at("all"), (std::vector<Real>{Real(4), Real(2), Real(1)}));
}

TYPED_TEST(Interpret, AnArrayThatIsNotGivenIsZero) {
  using Real = TypeParam;
  const auto results = interpret<Real>(test::program(kTwoArrays), {{"p", {Real(4)}}});
  EXPECT_EQ(results.at("all"), (std::vector<Real>{Real(4), Real(0), Real(0)}));
}

TYPED_TEST(Interpret, WrongArraysAreInternalFaults) {
  using Real = TypeParam;
  const Program p = test::program(kTwoArrays);
  EXPECT_THROW(interpret<Real>(p, {{"q", {Real(1)}}}), std::logic_error);
  EXPECT_THROW(interpret<Real>(p, {{"q", {Real(1), Real(2), Real(3)}}}), std::logic_error);
  EXPECT_THROW(interpret<Real>(p, {{"r", {Real(1)}}}), std::logic_error);
}

TEST(InterpretProperty, AgreesWithAnotherEvaluator) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    test::RandomPrograms random(seed);
    const Program p = random.make();
    ASSERT_EQ(test::difference(p, p, random.inputs()), "") << "seed " << seed << "\n" << print(p);
  }
}

}  // namespace
}  // namespace robcogen::symbolic::interpret_test
