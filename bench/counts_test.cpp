#include "counts.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace robcogen::bench {
namespace {

const Counts kCounts = {
    {"Arm", {{"transforms.homogeneous.a_X_b", {1, 2, 0, 0, 1, 3, 8}}}},
    {"Leg", {{"inverse_dynamics", {30, 20, 0, 0, 2, 36, 44}}, {"bias_forces", {10, 9, 1, 1, 2, 15, 40}}}}};

TEST(Counts, ReadOperations) {
  const std::vector<Counted> functions = read_operations(
      R"({"robot": "Leg", "functions": [{"name": "f", "mul": 1, "add": 2, "div": 3, "sqrt": 4, "sincos": 5,
          "instructions": 6, "critical_path": 7}]})");
  EXPECT_EQ(functions, (std::vector<Counted>{{"f", {1, 2, 3, 4, 5, 6, 7}}}));
}

TEST(Counts, FilesAreReadAsTheyWereWritten) {
  const std::string text = counts_text(kCounts);
  EXPECT_EQ(read_counts(text), kCounts);
  // A line for each function, so that differences of files read well.
  EXPECT_NE(text.find("\n      \"bias_forces\": [10, 9, 1, 1, 2, 15, 40]\n"), std::string::npos) << text;
}

TEST(Counts, FilesOfOtherNumbersAreRefused) {
  EXPECT_THROW(read_counts("no JSON"), nlohmann::json::exception);
  EXPECT_THROW(read_counts(R"({"columns": ["mul"], "robots": {}})"), std::runtime_error);
  std::string text = counts_text(kCounts);
  text.replace(text.find("10, 9, "), 7, "10, ");
  EXPECT_THROW(read_counts(text), std::runtime_error);
}

TEST(Counts, NothingChanged) {
  const Changes none = changes("Leg", kCounts.at("Leg"), kCounts.at("Leg"));
  EXPECT_TRUE(none.worse.empty() && none.other.empty());
}

TEST(Counts, RisesAndFallsSayWhereAndHowMuch) {
  const Changes found =
      changes("Leg", kCounts.at("Leg"), {{"inverse_dynamics", {33, 18, 0, 0, 2, 36, 44}}, {"forward_dynamics", {1}}});
  EXPECT_EQ(found.worse, (std::vector<std::string>{"Leg, inverse_dynamics: mul 30 -> 33", "Leg, bias_forces: gone"}));
  EXPECT_EQ(
      found.other, (std::vector<std::string>{"Leg, inverse_dynamics: add 20 -> 18", "Leg, forward_dynamics: new"}));
}

}  // namespace
}  // namespace robcogen::bench
