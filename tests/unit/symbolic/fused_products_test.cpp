#include "symbolic/fused_products.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace robcogen::symbolic::fused_products_test {
namespace {

// `users`: the uses of each product.
int fused(const std::vector<std::vector<int>>& users, std::size_t size) {
  FusedProducts products(std::max(users.size(), size));
  for (std::size_t i = users.size(); i-- > 0;) {
    for (const int user : users[i]) products.add_use(static_cast<int>(i), user);
    products.add(static_cast<int>(i));
  }
  return products.count();
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

TEST(FusedProducts, StayWhereSomethingElseUsesThem) {
  EXPECT_EQ(fused({{0, FusedProducts::kOther}}, 1), 0);
}

// The product with two uses comes first in the list and would block the sums of the two others.
TEST(FusedProducts, GoFirstWithFewestUses) {
  EXPECT_EQ(fused({{0, 1}, {0}, {1}}, 2), 2);
}

}  // namespace
}  // namespace robcogen::symbolic::fused_products_test
