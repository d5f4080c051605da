#include "support/source.h"

#include <gtest/gtest.h>

namespace robcogen::source_test {
namespace {

void expect_place(const Source& source, std::size_t offset, std::size_t line, std::size_t column) {
  EXPECT_EQ(source.locate(offset).line, line) << "offset " << offset;
  EXPECT_EQ(source.locate(offset).column, column) << "offset " << offset;
}

TEST(Source, CountsLinesAndColumnsFromOne) {
  const Source source("a.txt", "ab\ncd\n\ne");
  EXPECT_EQ(source.name(), "a.txt");
  expect_place(source, 0, 1, 1);
  expect_place(source, 2, 1, 3);  // a line end belongs to its line
  expect_place(source, 3, 2, 1);
  expect_place(source, 6, 3, 1);
  expect_place(source, 7, 4, 1);
  expect_place(source, 8, 4, 2);     // the end of the text
  expect_place(source, 1000, 4, 2);  // and beyond it
}

TEST(Source, KnowsTheLineEndsOfAllSystems) {
  const Source source("", "ab\r\ncd\ref\n");
  expect_place(source, 4, 2, 1);
  expect_place(source, 7, 3, 1);
  EXPECT_EQ(source.line_at(1), "ab");
  EXPECT_EQ(source.line_at(3), "ab");
  EXPECT_EQ(source.line_at(5), "cd");
  EXPECT_EQ(source.line_at(8), "ef");
  EXPECT_EQ(source.line_at(10), "");
}

TEST(Source, HidesAByteOrderMark) {
  const Source source("", "\xef\xbb\xbfRobot");
  expect_place(source, 0, 1, 1);
  expect_place(source, 3, 1, 1);
  expect_place(source, 5, 1, 3);
  EXPECT_EQ(source.line_at(0), "Robot");
}

TEST(Source, MayBeEmpty) {
  for (const char* text : {"", "\xef\xbb\xbf"}) {
    const Source source("", text);
    expect_place(source, 0, 1, 1);
    expect_place(source, 3, 1, 1);
    EXPECT_EQ(source.line_at(0), "");
  }
}

}  // namespace
}  // namespace robcogen::source_test
