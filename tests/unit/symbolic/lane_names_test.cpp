// Names of lanes: the common part of their limbs' names.
#include "symbolic/lane_names.h"

#include <gtest/gtest.h>

namespace robcogen::symbolic::lane_names_test {
namespace {

TEST(LaneNames, AreWhatNamesHaveInCommon) {
  EXPECT_EQ(common_name({"LF_upperleg_wx", "RF_upperleg_wx", "LH_upperleg_wx"}), "upperleg_wx");
  EXPECT_EQ(common_name({"s_LF_HFE", "s_RF_HFE"}), "s_HFE");
  EXPECT_EQ(common_name({"wx_left", "wx_right"}), "wx");
  EXPECT_EQ(common_name({"trunk_t3", "trunk_t3"}), "trunk_t3");
  EXPECT_EQ(common_name({"trunk_t3"}), "trunk_t3");
}

// LEFT and LOWER have a letter in common, but no word.
TEST(LaneNames, KeepWholeWords) {
  EXPECT_EQ(common_name({"LEFT_hip_wx", "LOWER_hip_wx"}), "hip_wx");
  EXPECT_EQ(common_name({"LF_legA", "RF_legA"}), "legA");
  EXPECT_EQ(common_name({"legA", "legB"}), "lanes");
  EXPECT_EQ(common_name({"LF_innerleg", "RF_outerleg"}), "lanes");
}

TEST(LaneNames, OneLimbMayShareAValueWithAnotherPart) {
  EXPECT_EQ(common_name({"trunk", "RF_hip", "LH_hip", "RH_hip"}), "hip");
  EXPECT_EQ(common_words({"trunk", "RF_hip", "LH_hip", "RH_hip"}), "");
}

// The common beginning and end must not overlap in the shortest name.
TEST(LaneNames, FitIntoEachName) {
  EXPECT_EQ(common_name({"a_a", "a_a_a"}), "a");
  EXPECT_EQ(common_name({"t_1_t", "t_1_1_t"}), "t_1");
}

TEST(LaneNames, AreIdentifiers) {
  EXPECT_EQ(common_name({"a", "b"}), "lanes");
  EXPECT_EQ(common_name({"LF_2nd", "RF_2nd"}), "lanes_2nd");
  EXPECT_EQ(common_name({"L_x", "R_y"}), "lanes");
}

TEST(LaneNames, OfSectionsSayWhichLimbs) {
  EXPECT_EQ(common_title({"link LF_foot: force", "link RF_foot: force"}), "link foot of LF, RF: force");
  EXPECT_EQ(common_title({"joint LF_HFE", "joint RF_HFE", "joint LF_HFE"}), "joint HFE of LF, RF");
  EXPECT_EQ(
      common_title({"link LF_hip: column of joint LF_HAA", "link RF_hip: column of joint RF_HAA"}),
      "link hip of LF, RF: column of joint HAA");
  EXPECT_EQ(common_title({"link hip_left: force", "link foot_right: force"}), "link hip_left, foot_right: force");
  EXPECT_EQ(common_title({"base: acceleration", "base: acceleration"}), "base: acceleration");
  EXPECT_EQ(common_title({"base", "link foot"}), "base, link foot");
}

}  // namespace
}  // namespace robcogen::symbolic::lane_names_test
