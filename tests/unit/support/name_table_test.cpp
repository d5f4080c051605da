#include "support/name_table.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace robcogen::name_table_test {
namespace {

TEST(NameTable, KeepsTheFirstValueOfAName) {
  NameTable<int> table;
  EXPECT_EQ(table.find("arm"), nullptr);
  const auto [first, is_new] = table.try_emplace("arm", 1);
  EXPECT_TRUE(is_new);
  EXPECT_EQ(*first, 1);
  const auto [again, is_new_again] = table.try_emplace("arm", 2);
  EXPECT_FALSE(is_new_again);
  EXPECT_EQ(*again, 1);
  *again = 3;
  EXPECT_EQ(*table.find("arm"), 3);
  EXPECT_EQ(table.find("ar"), nullptr);
  EXPECT_EQ(table.find(""), nullptr);
}

// The table owns its names, of any length, after it has grown and after it was moved.
TEST(NameTable, KeepsNamesAsItGrows) {
  NameTable<int> table;
  const auto name = [](int k) { return std::string(static_cast<std::size_t>(k % 40), 'a') + std::to_string(k); };
  for (int k = 0; k < 5000; ++k) EXPECT_TRUE(table.try_emplace(name(k), k).second);
  const NameTable<int> moved = std::move(table);
  for (int k = 0; k < 5000; ++k) ASSERT_EQ(*moved.find(name(k)), k);
  EXPECT_EQ(moved.find(name(5000)), nullptr);
}

}  // namespace
}  // namespace robcogen::name_table_test
