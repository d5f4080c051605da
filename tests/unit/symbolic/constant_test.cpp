// Constants that fold like a representative of their set.
#include "symbolic/constant.h"

#include <gtest/gtest.h>

namespace robcogen::symbolic::constant_test {
namespace {

const Constant kZero = Constant().folded_as(0.25), kHalf = Number::rational(1, 2);

TEST(Constant, IsZeroOnlyWhereItsRepresentativeIs) {
  EXPECT_FALSE(kZero.is_zero());
  EXPECT_EQ(kZero.value(), 0.0);
  EXPECT_NE(kZero, Constant());
  EXPECT_EQ(kZero.number(), Number());
  EXPECT_FALSE(kZero.folds_as_itself());
  EXPECT_TRUE(kHalf.folds_as_itself());
}

TEST(Constant, ArithmeticIsThatOfTheNumbersAndOfTheRepresentatives) {
  EXPECT_EQ((kHalf + kZero).number(), kHalf.number());
  EXPECT_EQ((kHalf + kZero).representative(), 0.75);
  EXPECT_EQ((kHalf - kZero).representative(), 0.25);
  EXPECT_EQ((kHalf * kZero).number(), Number());
  EXPECT_EQ((kHalf * kZero).representative(), 0.125);
  EXPECT_EQ((kZero / kHalf).representative(), 0.5);
  EXPECT_EQ((-kZero).representative(), -0.25);
  EXPECT_EQ(-(-kZero), kZero);
}

TEST(Constant, IsZeroWhereBothAre) {
  EXPECT_TRUE((kZero - kZero).is_zero());
  EXPECT_TRUE((kZero * Constant()).is_zero());
  // the number is zero and the representative is not, or the other way round
  EXPECT_FALSE((kHalf.folded_as(1.0) - kHalf).is_zero());
  EXPECT_FALSE((kHalf.folded_as(0.0) + Constant()).is_zero());
}

TEST(Constant, HasNoRepresentativeThatIsNotANumber) {
  EXPECT_EQ(kHalf / Constant(Number::rational(1)).folded_as(0.0), kHalf);
}

}  // namespace
}  // namespace robcogen::symbolic::constant_test
