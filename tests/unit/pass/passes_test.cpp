// The list of passes and its order.
#include "pass/passes.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "symbolic/programs.h"

namespace robcogen::pass::passes_test {
namespace {

const std::string kProgram =
    "in 0\n"
    "tmp x = a[0] + a[1]\n"
    "tmp dead = a[2] * 0.0\n"
    "tmp y = a[1] + a[0]\n"
    "in 1\n"
    "tmp z = x * y\n"
    "return out z\n";

TEST(Passes, Names) {
  EXPECT_EQ(names(), (std::vector<std::string>{"canonical", "reassociate", "sink"}));
}

TEST(Passes, NoneLeavesTheProgramAlone) {
  const symbolic::Program p = test::small_program(kProgram);
  EXPECT_EQ(print(run(p, {})), print(p));
}

TEST(Passes, EachRunsByItsName) {
  const symbolic::Program p = test::small_program(kProgram);
  EXPECT_EQ(print(run(p, {"canonical"})), print(canonical(p)));
  EXPECT_EQ(print(run(p, {"reassociate"})), print(reassociate(p)));
  EXPECT_EQ(print(run(p, {"sink"})), print(sink(p)));
}

TEST(Passes, TheOrderIsTheirsNotTheCallers) {
  const symbolic::Program p = test::small_program(kProgram);
  EXPECT_EQ(print(run(p, {"sink", "canonical"})), print(run(p, {"canonical", "sink"})));
  EXPECT_EQ(print(run(p, {"sink", "canonical"})), print(sink(canonical(p))));
}

TEST(Passes, AnUnknownNameIsAnInternalFault) {
  EXPECT_THROW(run(test::small_program(kProgram), {"sink", "inline"}), std::logic_error);
}

}  // namespace
}  // namespace robcogen::pass::passes_test
