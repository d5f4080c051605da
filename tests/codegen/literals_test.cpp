// A literal in generated code is the double that it stands for.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "literals/literals.h"
#include "samples.h"

namespace robcogen::test::literals_test {
namespace {

TEST(Literals, AreTheSameDoubleInGeneratedCode) {
  const std::vector<double>& expected = literal_values();
  const auto found = ::literals::literals();
  ASSERT_EQ(static_cast<std::size_t>(found.size()), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const double value = found[static_cast<Eigen::Index>(k)];
    EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected[k])) << expected[k];
  }
}

}  // namespace
}  // namespace robcogen::test::literals_test
