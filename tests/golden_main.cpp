// A GoogleTest program that accepts `--update`: it then writes what it expects instead of comparing it.
#include <cstdio>
#include <cstring>

#include "golden_test.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--update") != 0) {
      std::fprintf(stderr, "usage: %s [--update] [GoogleTest's options]\n", argv[0]);
      return 2;
    }
    robcogen::test::update_goldens = true;
    if (testing::GTEST_FLAG(filter) == "*") testing::GTEST_FLAG(filter) = "*.AreAsExpected*";
  }
  return RUN_ALL_TESTS();
}
