// The pictures in the guides are those that the project draws.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>
#include <vector>

#include "markdown.h"

namespace robcogen::test {
namespace {

namespace fs = std::filesystem;

// The simulation rounds differently on other processors, and pictures have a resolution of a tenth of a pixel.
constexpr double kPixels = 0.5;

std::string draw(const std::string& command) {
  const fs::path file = scratch("picture");
  fs::remove(file);
  int status = 0;
  const std::string output = output_of(command + " '" + file.string() + "'", status);
  EXPECT_EQ(status, 0) << output;
  std::string drawing = read_text(file);
  fs::remove(file);
  return drawing;
}

// Returns the numbers of a text, and the text between them.
std::pair<std::vector<double>, std::string> numbers(const std::string& text) {
  std::pair<std::vector<double>, std::string> result;
  for (std::size_t at = 0; at < text.size();) {
    const bool is_number = text[at] >= '0' && text[at] <= '9' && (at == 0 || text[at - 1] != '#');
    char* end = nullptr;
    if (is_number) {
      result.first.push_back(std::strtod(text.c_str() + at, &end));
      at = static_cast<std::size_t>(end - text.c_str());
    } else {
      result.second += text[at++];
    }
  }
  return result;
}

void expect_same(const std::string& drawing, const std::string& name, std::size_t least_count) {
  const auto [drawn, drawn_text] = numbers(drawing);
  const auto [shown, shown_text] = numbers(read_text(source_folder() / name));
  ASSERT_EQ(drawn.size(), shown.size()) << name << " is not the program's: build the target update_documents";
  ASSERT_GT(drawn.size(), least_count) << name;
  EXPECT_EQ(drawn_text, shown_text) << name;
  double most = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) most = std::max(most, std::abs(drawn[i] - shown[i]));
  EXPECT_LE(most, kPixels) << name;
}

TEST(Pictures, ChartIsThatOfTheTables) {
  const std::string drawing = draw("'" ROBCOGEN_DRAW_CHART "' '" ROBCOGEN_SOURCE_DIR "/bench/FIGURES.md'");
  EXPECT_NE(drawing.find("MuJoCo, Humanoid"), std::string::npos);
  EXPECT_EQ(drawing, read_text(source_folder() / "bench/chart.svg"))
      << "bench/chart.svg does not show the tables of bench/FIGURES.md: build the target update_documents";
}

TEST(Pictures, ChartOfGeneratorsIsThatOfTheTable) {
  const std::string drawing = draw("'" ROBCOGEN_DRAW_CHART "' --generators '" ROBCOGEN_SOURCE_DIR "/bench/README.md'");
  EXPECT_NE(drawing.find("RobCoGen 5.0.1, TALOS"), std::string::npos);
  EXPECT_EQ(drawing, read_text(source_folder() / "bench/generators.svg"))
      << "bench/generators.svg does not show the table of bench/README.md: build the target update_documents";
}

TEST(Pictures, HopIsThatOfTheDemo) {
  expect_same(draw("'" ROBCOGEN_HOP "'"), "robots/demo/hop.svg", 1000);
}

TEST(Pictures, DesignsAreThoseOfTheStudies) {
  expect_same(draw("'" ROBCOGEN_SQUAT_JUMP "'"), "robots/design/squat_jump.svg", 300);
  expect_same(draw("'" ROBCOGEN_TROT_POWER "'"), "robots/design/trot_power.svg", 300);
}

}  // namespace
}  // namespace robcogen::test
