// The text, run by Maxima on symbols.
#include <algorithm>

#include "maxima.h"

namespace robcogen::test::symbols_test {
namespace {

const std::filesystem::path kHere = TEST_SOURCE_DIR;

class MaximaSymbols : public WithMaxima {};

// Two robots, one for each convention of primitives; everything else is the same in both.
TEST_F(MaximaSymbols, AreWhatMaximaDerivesByItself) {
  const std::filesystem::path arm = kHere / "two_links.kindsl";
  std::string error;
  const std::optional<std::string> derivation = read_file(kHere / "two_links.mac", error);
  ASSERT_TRUE(derivation) << error;
  const std::vector<std::string> lines = run_maxima(
      {maxima_text(library_of(arm, "right", model::MovedFramePosition::right)),
       maxima_text(library_of(arm, "left", model::MovedFramePosition::left)),
       {"two_links.mac", *derivation}});
  EXPECT_EQ(lines.size(), 23U);
  for (const std::string& line : lines) EXPECT_TRUE(line.ends_with(" true")) << line;
}

#if ROBCOGEN_TEST_EVERYTHING
// Checks the check itself: it does not accept a nonzero value as zero.
TEST_F(MaximaSymbols, ThatDifferAreFoundOut) {
  const std::filesystem::path arm = kHere / "two_links.kindsl";
  std::string error;
  const std::optional<std::string> derivation = read_file(kHere / "two_links.mac", error);
  ASSERT_TRUE(derivation) << error;
  OutputFile right = maxima_text(library_of(arm, "right", model::MovedFramePosition::right));
  const std::size_t function = right.text.find("right_homogeneous_fr_base_X_tip(");
  ASSERT_NE(function, std::string::npos);
  const std::size_t sign = right.text.find(" + ", function);
  right.text[sign + 1] = '-';
  const std::vector<std::string> lines = run_maxima(
      {right, maxima_text(library_of(arm, "left", model::MovedFramePosition::left)), {"two_links.mac", *derivation}});
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines[0], "homogeneous by hand false");
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const auto& line) { return line.ends_with(" false"); }), 4);
}

TEST_F(MaximaSymbols, OfParametersAreNumbersWhereTheyAreDeclared) {
  const backend::Library arm = library_of(kHere / "two_links.kindsl", "arm");
  backend::Library declared = arm;
  declared.name = "declared";
  declared.tree.parameters.front().default_value = 0.25;
  const std::vector<std::string> lines = run_maxima(
      {maxima_text(arm),
       maxima_text(declared),
       {"show.mac", "print(\"=\", arm_parameters())$ print(\"=\", declared_parameters())$"}});
  EXPECT_EQ(
      lines,
      (std::vector<std::string>{"[m1, c1, i1, m2, c2, i2, l2, h, l1]", "[0.25, c1, i1, m2, c2, i2, l2, h, l1]"}));
}

// Constants are as exact as the document's: a quarter turn leaves no rounded zero, and a tenth is a tenth.
TEST_F(MaximaSymbols, AreExact) {
  const backend::Library hyl = library_of(
      std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / "hyl" / "hyl.kindsl", "hyl", model::MovedFramePosition::right);
  const std::vector<std::string> lines = run_maxima(
      {maxima_text(hyl),
       {"show.mac",
        "display2d: false$ print(\"=\", hyl_homogeneous_fr_base_X_fr_upperleg([x, 0, y]))$\n"
        "print(\"=\", hyl_product_fr_base_X_fr_upperleg([x, y, z]))$"}});
  EXPECT_EQ(
      lines, (std::vector<std::string>{
                 "matrix([0,-1,0,0],[0,0,1,13/100],[-1,0,0,x-2/25],[0,0,0,1])",
                 "Tz(x) . Ty(13/100) . Tz(-2/25) . Rx(-%pi/2) . Rz(%pi/2) . Rz(y)"}));
}
#endif

}  // namespace
}  // namespace robcogen::test::symbols_test
