// The elements that are moved in blocks.
#include "symbolic/blocks.h"

#include <gtest/gtest.h>

#include <string>

#include "programs.h"

namespace robcogen::symbolic::blocks_test {
namespace {

using test::program;

// Two limbs of two joints each.
Program limbs(const std::string& statements, int outputs) {
  return program(
      "program limbs\n"
      "input q value a0 a1 b0 b1\n"
      "output out value " +
      std::to_string(outputs) +
      " 1\n"
      "section limbs limbs\n" +
      statements);
}

const std::string kValues =
    "tmp first = gather q[0] q[2]\n"
    "tmp second = gather q[1] q[3]\n"
    "let x = first * second\n"
    "let y = x + first\n";

// The columns as `x 0 -y`: by name, or as numbers.
std::string columns(const Program& p, const Block& block) {
  std::string result;
  for (const Operand& o : block.columns) {
    const auto index = static_cast<std::size_t>(o.index);
    result += std::string(result.empty() ? "" : " ") + (o.negative ? "-" : "");
    result += is_statement(o) ? p.statements[index].name : std::to_string(static_cast<int>(p.constants[index].value()));
  }
  return result;
}

void expect(const Block& block, int first, int stride, int width) {
  EXPECT_EQ(block.array, 0);
  EXPECT_EQ(block.first, first);
  EXPECT_EQ(block.stride, stride);
  EXPECT_EQ(block.width, width);
}

TEST(Stores, LanesOfLimbsThatFollowEachOtherAreOneBlock) {
  const Program p = limbs(kValues + "return out x@0 y@0 x@1 y@1\n", 4);
  const Stores found = stores(p);
  ASSERT_EQ(found.blocks.size(), 1U);
  expect(found.blocks[0], 0, 2, 2);
  EXPECT_EQ(columns(p, found.blocks[0]), "x y");
}

// From the second limb to the first: a block only goes forward.
TEST(Stores, LanesInTheOppositeOrderAreNoBlock) {
  const Program p = limbs(kValues + "return out x@1 y@1 x@0 y@0\n", 4);
  EXPECT_TRUE(stores(p).blocks.empty());
}

// Runs of one constant are filled together if this takes no more vectors, otherwise separately.
TEST(Stores, AFillGoesOnBehindAGapThatCostsNothing) {
  const Program near = limbs(kValues + "return out 0 0 0 0 x@0 0 0 0 0\n", 9);
  ASSERT_EQ(stores(near).fills.size(), 2U) << "three vectors in the place of two";
  const Program in_a_vector = limbs(kValues + "return out 0 0 0 0 0 x@0 0 0 0 0\n", 10);
  ASSERT_EQ(stores(in_a_vector).fills.size(), 1U) << "three vectors in the place of three";
  EXPECT_EQ(stores(in_a_vector).fills[0].count, 10);
  const Program far = limbs(kValues + "return out 0 0 0 0 x@0 y@0 x@0 y@0 x@0 y@0 0 0 0 0\n", 14);
  const Stores found = stores(far);
  ASSERT_EQ(found.fills.size(), 2U);
  EXPECT_EQ(found.fills[0].first, 0);
  EXPECT_EQ(found.fills[0].count, 4);
  EXPECT_EQ(found.fills[1].first, 10);
  EXPECT_EQ(found.fills[1].count, 4);
}

TEST(Stores, RowsAndColumnsOfASymmetricMatrixAreBlocksOfTheirOwn) {
  // x and y are in the first column of a matrix with five rows, and in its first row.
  const Program p =
      limbs(kValues + "return out 1 x@0 y@0 x@1 y@1 x@0 2 0 0 0 y@0 0 2 0 0 x@1 0 0 2 0 y@1 0 0 0 2\n", 25);
  const Stores found = stores(p);
  ASSERT_EQ(found.blocks.size(), 1U);
  expect(found.blocks[0], 1, 2, 2);
}

TEST(Stores, AConstantThatIsTheSameInAllLanesMayStandBetween) {
  const Program p = limbs(kValues + "return out x@0 0 -y@0 x@1 0 -y@1\n", 6);
  const Stores found = stores(p);
  ASSERT_EQ(found.blocks.size(), 1U);
  expect(found.blocks[0], 0, 3, 2);
  EXPECT_EQ(columns(p, found.blocks[0]), "x 0 -y");
}

TEST(Stores, SignsThatDifferFromLaneToLaneMakeNoBlock) {
  EXPECT_TRUE(stores(limbs(kValues + "return out x@0 y@0 x@1 -y@1\n", 4)).blocks.empty());
}

TEST(Stores, OneValueAloneIsNoBlock) {
  EXPECT_TRUE(stores(limbs(kValues + "return out x@0 q[0] x@1 q[1]\n", 4)).blocks.empty());
}

TEST(Stores, EqualConstantsAreFilledInAcrossWhatIsWrittenLater) {
  const Program p = limbs(kValues + "return out 0 0 0 x@0 0 0 0 x@1 1 1 0 0\n", 12);
  const Stores found = stores(p);
  ASSERT_EQ(found.fills.size(), 1U);
  EXPECT_EQ(found.fills[0].first, 0);
  EXPECT_EQ(found.fills[0].count, 7);
  EXPECT_EQ(p.constants[static_cast<std::size_t>(found.fills[0].value.index)].value(), 0);
}

TEST(Stores, WithoutLanesThereIsNothingToMove) {
  const Stores found = stores(limbs("let x = q[0] * q[1]\nreturn out x 0 0 0 0 0 0 0\n", 8));
  EXPECT_TRUE(found.blocks.empty());
  EXPECT_TRUE(found.fills.empty());
}

TEST(Loads, GathersOfInputsThatFollowEachOther) {
  const Program p = limbs(kValues + "return out x@0 y@1\n", 2);
  const std::vector<Block> found = loads(p);
  ASSERT_EQ(found.size(), 1U);
  expect(found[0], 0, 2, 2);
  EXPECT_EQ(columns(p, found[0]), "first second");
}

TEST(Loads, NotAtUnequalDistancesOrNegated) {
  EXPECT_TRUE(
      loads(limbs("tmp x = gather q[0] -q[2]\ntmp y = gather q[1] q[3]\nlet z = x * y\nreturn out z@0\n", 1)).empty());
  EXPECT_TRUE(
      loads(limbs("tmp x = gather q[2] q[0]\ntmp y = gather q[3] q[1]\nlet z = x * y\nreturn out z@0\n", 1)).empty());
}

TEST(Moves, ThreeColumnsOfFourLanesWithoutGapTakeSixShuffles) {
  const Operand column;
  EXPECT_EQ(moves({0, 0, 3, 4, {column, column, column}}), 6);
  EXPECT_EQ(moves({0, 0, 18, 4, {column, column, column, column}}), 8);
  EXPECT_EQ(moves({0, 0, 18, 8, {column, column, column, column}}), 16);
  EXPECT_EQ(moves({0, 0, 18, 2, {column, column}}), 2);
}

}  // namespace
}  // namespace robcogen::symbolic::blocks_test
