#include "support/texts.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace robcogen::texts_test {
namespace {

TEST(Texts, ArePiecesOneAfterAnother) {
  Texts texts;
  EXPECT_EQ(texts.add({"a", "", " + ", "b"}), "a + b");
  EXPECT_EQ(texts.add({}), "");
}

// More texts than fit in one block, and one that is longer than a block.
TEST(Texts, StayWhereTheyAreWhenOthersComeAndWhenMoved) {
  Texts texts;
  std::vector<std::string_view> views;
  std::vector<std::string> copies;
  for (int k = 0; k < 10000; ++k) {
    copies.push_back(k == 5000 ? std::string(100000, 'x') : "text " + std::to_string(k));
    views.push_back(texts.add({copies.back().substr(0, 2), copies.back().substr(2)}));
  }
  Texts moved = std::move(texts);
  moved.add({"one more"});
  for (std::size_t k = 0; k < views.size(); ++k) ASSERT_EQ(views[k], copies[k]);
}

}  // namespace
}  // namespace robcogen::texts_test
