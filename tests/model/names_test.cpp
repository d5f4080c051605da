// Which names differ only by a typing error.
#include "import/names.h"

#include <gtest/gtest.h>

namespace robcogen::import::names_test {
namespace {

TEST(Names, DifferByASlipInsideAWord) {
  for (const auto& [a, b] : std::vector<std::pair<std::string, std::string>>{
           {"lenght", "length"},
           {"heigth", "height"},
           {"lngth", "length"},
           {"lennght", "lenght"},
           {"lenxth", "length"},
           {"arm_lenght", "arm_length"},
           {"upperArmMas2", "upperArmMass2"},
           {"mass", "masss"},
           {"Tilt", "tilt"}})
    EXPECT_TRUE(differ_by_slip(a, b) && differ_by_slip(b, a)) << a << " " << b;
}

TEST(Names, ThatTellThingsApartDoNot) {
  for (const auto& [a, b] : std::vector<std::pair<std::string, std::string>>{
           {"length", "length"},
           {"m1", "m2"},
           {"m", "M"},
           {"mass_1", "mass_2"},
           {"mass_11", "mass_1"},
           {"offset_x", "offset_y"},
           {"offsetx", "offsety"},
           {"arm_x", "arm_xy"},
           {"mass_LF", "mass_LH"},
           {"mass_LF", "mass_RF"},
           {"lhip", "rhip"},
           {"link", "links"},
           {"upper", "lower"},
           {"lengthx", "lenght"},
           {"Ixx", "Ixy"},
           {"a", "ab"},
           {"", "a"}})
    EXPECT_FALSE(differ_by_slip(a, b) || differ_by_slip(b, a)) << a << " " << b;
}

}  // namespace
}  // namespace robcogen::import::names_test
