#include "support/unique_names.h"

#include <gtest/gtest.h>

#include <vector>

namespace robcogen::unique_names_test {
namespace {

TEST(UniqueNames, TakeTheFirstFreeNumber) {
  UniqueNames names;
  names.reserve_all(std::vector<std::string>{"arm", "arm_3"});
  EXPECT_EQ(names.add("leg"), "leg");
  EXPECT_EQ(names.add("arm"), "arm_2");
  EXPECT_EQ(names.add("arm"), "arm_4");
  EXPECT_TRUE(names.contains("arm_4"));
  EXPECT_FALSE(names.contains("arm_5"));
}

TEST(UniqueNames, ThatAreReleasedAreFreeAgain) {
  UniqueNames names;
  for (int k = 0; k < 3; ++k) names.add("arm");
  names.release("arm_2");
  EXPECT_EQ(names.add("arm"), "arm_2");
  EXPECT_FALSE(names.reserve("arm_2"));
  EXPECT_TRUE(names.reserve("arm_4"));
}

}  // namespace
}  // namespace robcogen::unique_names_test
