#include "backend/cpp/layout.h"

#include <gtest/gtest.h>

namespace robcogen::backend::cpp::layout_test {
namespace {

using Texts = std::vector<std::string>;

TEST(Layout, ParametersStandOneALineWhereTheyDoNotFit) {
  EXPECT_EQ(declaration("void f", {"int a", "int b"}, " noexcept;"), "void f(int a, int b) noexcept;\n");
  const std::string a = "int " + std::string(60, 'a'), b = "int " + std::string(60, 'b');
  EXPECT_EQ(declaration("void f", {a, b}, ";", 2), "  void f(\n      " + a + ",\n      " + b + ");\n");
}

TEST(Layout, ArgumentsFillTheLine) {
  const std::string a(50, 'a'), b(50, 'b'), c(50, 'c');
  EXPECT_EQ(call("f", {a, b}, 2), "  f(" + a + ", " + b + ");\n");
  EXPECT_EQ(call("f", {a, b, c}, 2), "  f(\n      " + a + ", " + b + ",\n      " + c + ");\n");
}

TEST(Layout, RemarksOfListsStandInAColumn) {
  EXPECT_EQ(remarked_list("x", {"1", "200"}, {"one", "two"}), "x = {\n    1,    // one\n    200,  // two\n};\n");
  EXPECT_EQ(remarked_list("x", {}, {}), "x = {};\n");
}

TEST(Layout, RowsOfTablesAreNumbered) {
  EXPECT_EQ(
      table("x", {{1, "2"}, {3, Field(Texts{"4", "5"})}}),
      "x = {\n    {1, 2},       // 0\n    {3, {4, 5}},  // 1\n};\n");
}

TEST(Layout, TablesPutOneFieldALineWhenARowIsTooLong) {
  const std::string a(60, 'a'), b(60, 'b');
  EXPECT_EQ(
      table("x", {{a, Field(Texts{"1", "2"})}, {3, Field(Texts{a, b})}}),
      "x = {\n    {\n        " + a + ",\n        {1, 2},\n    },\n    {\n        3,\n        {\n            " + a +
          ",\n            " + b + ",\n        },\n    },\n};\n");
}

TEST(Layout, NamespacesAroundNothingVanish) {
  EXPECT_EQ(in_namespace("a::b", ""), "");
  EXPECT_EQ(in_namespace("a::b", "int x;\n"), "namespace a::b {\n\nint x;\n\n}  // namespace a::b\n");
}

}  // namespace
}  // namespace robcogen::backend::cpp::layout_test
