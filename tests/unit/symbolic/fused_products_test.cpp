#include "symbolic/fused_products.h"

#include <gtest/gtest.h>

namespace robcogen::symbolic {
namespace {

int fused(const std::vector<std::vector<int>>& products, std::size_t size) {
  return fused_products({products.begin(), products.end()}, size);
}

TEST(FusedProducts, AreNoneWithoutProducts) {
  EXPECT_EQ(fused({}, 3), 0);
}

TEST(FusedProducts, DisappearOnceInASum) {
  EXPECT_EQ(fused({{0}, {1}}, 2), 2);
  EXPECT_EQ(fused({{0}, {0}}, 1), 1);
}

TEST(FusedProducts, StayWhereASumTakesThemTwice) {
  EXPECT_EQ(fused({{0, 0}}, 1), 0);
}

TEST(FusedProducts, DisappearWhereEverySumTakesThem) {
  EXPECT_EQ(fused({{0, 1}}, 2), 1);
  EXPECT_EQ(fused({{1}, {0, 1}}, 2), 1);
}

// The product with two uses comes first in the list and would block the sums of the two others.
TEST(FusedProducts, GoFirstWithFewestUses) {
  EXPECT_EQ(fused({{0, 1}, {0}, {1}}, 2), 2);
}

}  // namespace
}  // namespace robcogen::symbolic
