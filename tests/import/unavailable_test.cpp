#include <gtest/gtest.h>

#include "import/mjcf.h"
#include "import/sdf.h"
#include "import/urdf.h"

namespace robcogen {
namespace {

TEST(Urdf, IsRefusedWithTheWayToHaveItRead) {
  Diagnostics diagnostics;
  EXPECT_FALSE(import::urdf(std::make_shared<Source>("arm.urdf", "<robot/>"), {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "urdf-unavailable");
  EXPECT_NE(diagnostics.all()[0].hint.find("liburdfdom-dev"), std::string::npos);
}

TEST(Mjcf, IsRefusedWithTheWayToHaveItRead) {
  Diagnostics diagnostics;
  EXPECT_FALSE(import::mjcf(std::make_shared<Source>("arm.xml", "<mujoco/>"), "arm.xml", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "mjcf-unavailable");
  EXPECT_NE(diagnostics.all()[0].hint.find("libtinyxml-dev"), std::string::npos);
}

TEST(Sdf, IsRefusedWithTheWayToHaveItRead) {
  Diagnostics diagnostics;
  EXPECT_FALSE(import::sdf(std::make_shared<Source>("arm.sdf", "<sdf/>"), "arm.sdf", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "sdf-unavailable");
  EXPECT_NE(diagnostics.all()[0].hint.find("libtinyxml-dev"), std::string::npos);
}

}  // namespace
}  // namespace robcogen
