// Numbers of an old program that must be those of the library's own functions.
#pragma once

#include <gtest/gtest.h>

namespace robcogen::test {

constexpr double kRounding = 1e-12;  // the same kernels: only the order of sums in the getters differs

template <class A, class B>
void expect_equal(const A& a, const B& b) {
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), kRounding) << a << "\nand\n" << b;
}

}  // namespace robcogen::test
