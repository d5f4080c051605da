// Signs of lanes: vectors over the field of two elements, up to a common sign.
#include "pass/lanes/lane_signs.h"

#include <gtest/gtest.h>

#include <random>

namespace robcogen::pass::lane_signs_test {
namespace {

bool is_plain(const Sign& sign) {
  return sign.lanes == 0 && sign.variables.empty();
}

TEST(LaneSigns, AreThoseOfTheFirstLaneAgainstTheOthers) {
  const Signs signs(4);
  EXPECT_EQ(signs.all(), 0b1111u);
  EXPECT_EQ(signs.fixed(0b0110).lanes, 0b0110u);
  EXPECT_EQ(signs.fixed(0b1001).lanes, 0b0110u);
  EXPECT_TRUE(is_plain(signs.fixed(0b1111)));
  EXPECT_TRUE(is_plain(signs.fixed(0)));
}

TEST(LaneSigns, OfAProductAreThoseThatOneFactorHasAlone) {
  Signs signs(4);
  const Sign x = signs.variable(true), y = signs.variable(true);
  const Sign a = signs.product(x, signs.fixed(0b0110)), b = signs.product(y, signs.product(x, signs.fixed(0b0010)));
  EXPECT_EQ(signs.product(a, b).lanes, 0b0100u);
  EXPECT_EQ(signs.product(a, b).variables, y.variables);
  EXPECT_EQ(signs.product(a, b).variables, signs.product(b, a).variables);
  EXPECT_TRUE(is_plain(signs.product(a, a)));
}

TEST(LaneSigns, ThatNobodyChoseArePlain) {
  Signs signs(4);
  const Sign x = signs.variable(true);
  EXPECT_EQ(signs.value(x), 0u);
  EXPECT_EQ(signs.value(signs.product(x, signs.fixed(0b0100))), 0b0100u);
}

// x + (y negated in lanes 1 and 2), with x given: y is kept with the signs with which both terms agree.
TEST(LaneSigns, AreChosenSoThatTermsAgree) {
  Signs signs(4);
  const Sign x = signs.fixed(0b1000), y = signs.variable(true), term = signs.product(y, signs.fixed(0b0110));
  signs.make_plain(signs.product(x, term));
  EXPECT_EQ(signs.value(term), signs.value(x));
  EXPECT_EQ(signs.value(y), 0b1110u);
}

TEST(LaneSigns, OfConstantsAreChosenFirst) {
  Signs signs(2);
  const Sign value = signs.variable(true), number = signs.variable(false), later = signs.variable(true);
  signs.make_plain(signs.product(signs.product(value, number), signs.product(later, signs.fixed(0b10))));
  EXPECT_EQ(signs.value(number), 0b10u);
  EXPECT_EQ(signs.value(value), 0u);
  EXPECT_EQ(signs.value(later), 0u);
}

TEST(LaneSigns, ThatAreChosenStay) {
  Signs signs(4);
  const Sign x = signs.variable(true);
  signs.make_plain(signs.product(x, signs.fixed(0b0010)));
  signs.make_plain(signs.product(x, signs.fixed(0b0100)));  // too late, because x is chosen
  EXPECT_EQ(signs.value(x), 0b0010u);
  signs.make_plain(signs.fixed(0b0100));  // nothing to choose
  EXPECT_EQ(signs.value(signs.fixed(0b0100)), 0b0100u);
}

// A value that was made plain stays plain, and the value of a product is the product of its factors' values.
TEST(LaneSigns, SolveLinearEquations) {
  constexpr int kVariables = 12, kEquations = 15;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    Signs signs(8);
    std::vector<Sign> variables;
    for (int k = 0; k < kVariables; ++k) variables.push_back(signs.variable(pick(2) == 0));
    std::vector<Sign> made_plain;
    int chosen = 0;
    for (int k = 0; k < kEquations; ++k) {
      Sign sign = signs.fixed(pick(256));
      for (const Sign& v : variables)
        if (pick(3) == 0) sign = signs.product(sign, v);
      const unsigned before = signs.value(sign);
      signs.make_plain(sign);
      if (signs.value(sign) != 0) {
        // No variable was left to choose, so the value is unchanged.
        EXPECT_EQ(signs.value(sign), before) << "seed " << seed;
        continue;
      }
      made_plain.push_back(sign);
      ++chosen;
    }
    EXPECT_GE(chosen, kVariables / 2) << "seed " << seed;
    for (const Sign& sign : made_plain) EXPECT_EQ(signs.value(sign), 0u) << "seed " << seed;
    for (const Sign& a : made_plain)
      for (const Sign& b : variables)
        EXPECT_EQ(signs.value(signs.product(a, b)), signs.fixed(signs.value(a) ^ signs.value(b)).lanes)
            << "seed " << seed;
  }
}

}  // namespace
}  // namespace robcogen::pass::lane_signs_test
