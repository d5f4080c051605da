// The names of a program's values.
#include "backend/common/value_names.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "programs.h"

namespace robcogen::backend::value_names_test {
namespace {

using symbolic::Program;
using symbolic::Statement;
using Names = std::vector<std::string>;

const std::string kHead =
    "program f\n"
    "input q joint_position HFE KFE\n"
    "input qd joint_velocity HFE KFE\n"
    "output tau joint_force 1 1\n"
    "section hip link hip: motion\n"
    "in 0\n";

// What the values with these names are.
const std::map<std::string, symbolic::Quantity> kQuantities = {
    {"hip_wx", {"hip", "w", "x"}}, {"hip_wy_neg", {"hip", "w", "y"}}, {"hip_wdz", {"hip", "wd", "z"}},
    {"hip_fx", {"hip", "f", "x"}}, {"hip_fy_neg", {"hip", "f", "y"}}, {"hip_nz", {"hip", "n", "z"}},
    {"hip_ax", {"hip", "a", "x"}}, {"hip_wx2", {"hip", "wx2"}}};

Program with_quantities(const std::string& statements) {
  Program p = test::described_program(kHead + statements);
  for (Statement& s : p.statements) {
    s.quantity = nullptr;
    const auto known = kQuantities.find(s.name);
    if (known == kQuantities.end()) continue;
    symbolic::Quantity quantity = known->second;
    quantity.negative = s.name.ends_with("_neg");
    s.quantity = std::make_shared<const symbolic::Quantity>(quantity);
  }
  return p;
}

// Compares the names of the last statements; every statement is a line.
void expect_last(const std::string& statements, const Names& expected) {
  const Program p = with_quantities(statements);
  const Names names = value_names(p, std::vector<bool>(p.statements.size(), true));
  ASSERT_GE(names.size(), expected.size());
  EXPECT_EQ(Names(names.end() - static_cast<std::ptrdiff_t>(expected.size()), names.end()), expected) << statements;
}

const std::string kRates = "let hip_wx = qd[0] * 2\nlet hip_wy_neg = qd[1] * 2\nlet hip_wdz = qd[0] * 3\n";

TEST(ValueNames, ProductsAndSquaresOfNamedValues) {
  expect_last(
      kRates +
          "tmp a = hip_wx * hip_wx\ntmp b = hip_wx * hip_wy_neg\ntmp c = hip_wx - hip_wdz\ntmp d = a + b\ntmp e = c + "
          "d\nreturn tau e\n",
      {"hip_wx2", "hip_wx_wy_neg", "hip_wx_minus_wdz", "hip_wx2_minus_wx_wy", "hip_t0"});
  expect_last("tmp a = qd[0] * qd[1]\nreturn tau a\n", {"qd_HFE_KFE"});
}

TEST(ValueNames, SinesAndCosinesOfTwiceAnAngle) {
  expect_last(
      "tmp s = sin q[0]\ntmp c = cos q[0]\ntmp a = s * s\ntmp b = c * s\ntmp d = 2 * b\ntmp e = 2 * a\n"
      "tmp f = 1 - e\ntmp g = d + f\nreturn tau g\n",
      {"s2_HFE", "sc_HFE", "s_2HFE", "c_2HFE_of_HFE", "c_2HFE", "hip_t0"});
}

// U = [wd]x + [w]x [w]x: in row y, column x, w_x w_y + wd_z; in row x, column y, w_x w_y - wd_z.
TEST(ValueNames, ElementsOfU) {
  expect_last(
      kRates + "tmp a = hip_wx * hip_wy_neg\ntmp b = hip_wdz - a\ntmp c = hip_wdz + a\ntmp d = b * c\nreturn tau d\n",
      {"hip_Uyx", "hip_Uxy_neg", "hip_Uyx_Uxy_neg"});
  expect_last(
      kRates + "tmp a = hip_wx * hip_wx\ntmp b = hip_wy_neg * hip_wy_neg\ntmp c = a + b\nreturn tau c\n",
      {"hip_Uzz_neg"});
}

TEST(ValueNames, ComponentsOfWhatTurnsAndMoves) {
  const std::string values = "let hip_fx = qd[0] * 2\nlet hip_fy_neg = qd[1] * 2\nlet hip_nz = qd[0] * 3\n";
  const std::string angles = "tmp s = sin q[1]\ntmp c = cos q[1]\n";
  expect_last(
      values + angles + "tmp a = c * hip_fx\ntmp b = s * hip_fy_neg\ntmp d = a + b\nreturn tau d\n",
      {"c_KFE_hip_fx", "s_KFE_hip_fy_neg", "hip_fx_by_KFE"});
  expect_last(
      values + angles + "tmp a = s * hip_fx\ntmp b = c * hip_fy_neg\ntmp d = a - b\nreturn tau d\n", {"hip_fy_by_KFE"});
  expect_last(values + "tmp a = 0.4 * hip_fx\ntmp b = hip_nz - a\nreturn tau b\n", {"hip_nz_moved"});
}

TEST(ValueNames, WhatIsLeftIsAPartOfWhatReadsIt) {
  expect_last(
      "let hip_ax = qd[0] * 2\ntmp a = 3 * hip_ax\ntmp b = a + 0.5\nlet hip_nz = b * qd[1]\nreturn tau hip_nz\n",
      {"hip_nz_of_ax", "hip_nz_to_ax", "hip_nz"});
}

// Statements that have lines whatever the widths are come first.
TEST(ValueNames, NumbersCountStatementsOfTheSection) {
  const Program p =
      with_quantities("tmp a = 3 + qd[0]\ntmp b = a + 0.5\ntmp c = b * b\ntmp d = sqrt c\nreturn tau d\n");
  EXPECT_EQ(value_names(p, {false, true, false, true}), (Names{"hip_t2", "hip_t0", "hip_t3", "hip_t1"}));
}

// Quantities of one limb and of another one, which are elements of a matrix over coordinates, or derived.
TEST(ValueNames, OfLanesAreWhatQuantitiesHaveInCommon) {
  const auto ref = [](symbolic::Quantity q) { return std::make_shared<const symbolic::Quantity>(std::move(q)); };
  const auto common = [](const std::vector<symbolic::QuantityRef>& lanes) {
    const auto shared = common_quantity(lanes);
    return shared ? text(*shared) : "";
  };
  symbolic::Quantity negative{"RF_hip", "w", "x"};
  negative.negative = true;
  EXPECT_EQ(common({ref({"LF_hip", "w", "x"}), ref(negative)}), "hip_wx");
  EXPECT_EQ(common({ref(negative), ref(negative)}), "RF_hip_wx_neg");
  EXPECT_EQ(common({ref({"LF_hip", "w", "x"}), ref({"RF_hip", "w", "y"})}), "");
  EXPECT_EQ(common({ref({"trunk", "a", "y"}), ref({"RF_hip", "a", "x"}), ref({"LH_hip", "a", "x"})}), "hip_ax");
  symbolic::Quantity left{"LF_HAA", "H"}, right{"RF_HAA", "H"};
  left.of_coordinates = right.of_coordinates = true;
  left.second = "LF_HFE", right.second = "RF_HFE";
  EXPECT_EQ(common({ref(left), ref(right)}), "H_HAA_HFE");
  EXPECT_EQ(
      common(
          {ref(symbolic::product({"LF_hip", "w", "x"}, {"LF_hip", "w", "y"})),
           ref(symbolic::product({"RF_hip", "w", "x"}, {"RF_hip", "w", "y"}))}),
      "hip_wx_wy");
}

TEST(ValueNames, AreDistinctAndKeepWhatTheAlgorithmNamed) {
  expect_last(
      kRates + "tmp a = hip_wx * hip_wx\nlet hip_wx2 = hip_wx + 1\ntmp b = a + hip_wx2\nreturn tau b\n",
      {"hip_t0", "hip_wx2", "hip_t1"});
}

}  // namespace
}  // namespace robcogen::backend::value_names_test
