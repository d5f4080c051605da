#include "chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>

namespace robcogen::bench {
namespace {

// Coordinates are written with two decimals.
constexpr double kPixels = 0.011;

std::vector<ChartPanel> example() {
  const std::vector<ChartSeries> series = {
      {"RobCoGen", {{"Leg", 2, false, 10}, {"Arm", 4, false, 100}, {"Dog", 6, true, 1000}}},
      {"A < \"B\" & C", {{"Leg", 2, false, 250}, {"Dog", 6, true, 9000}}}};
  return {{"inverse dynamics", series}, {"forward dynamics", series}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++number;
  return number;
}

// What is wrong with the nesting of tags, the attributes or the text; empty for well-formed XML of the simple kind that
// is written here: elements, attributes in double quotes, the five entities.
std::string fault(const std::string& xml) {
  static const std::regex tag(R"(<(/?)([a-z]+)((?: [a-z0-9A-Z:-]+="[^"<]*")*)(/?)>)");
  static const std::regex bad_entity("&(?!(?:amp|lt|gt|quot|apos);)");
  if (std::regex_search(xml, bad_entity)) return "an & of its own";
  std::vector<std::string> open;
  std::size_t end = 0;
  int roots = 0;
  for (std::sregex_iterator i(xml.begin(), xml.end(), tag), none; i != none; ++i) {
    const std::string between = xml.substr(end, static_cast<std::size_t>(i->position()) - end);
    if (between.find_first_of("<>") != std::string::npos) return "no tag: " + between;
    if (open.empty() && between.find_first_not_of(" \n") != std::string::npos) return "text outside: " + between;
    end = static_cast<std::size_t>(i->position() + i->length());
    if (i->str(1) == "/") {
      if (open.empty() || open.back() != i->str(2)) return "closes " + i->str(2);
      open.pop_back();
    } else {
      if (open.empty()) ++roots;
      if (i->str(4).empty()) open.push_back(i->str(2));
    }
  }
  if (!open.empty()) return "open: " + open.back();
  return roots == 1 && xml.substr(end) == "\n" ? "" : "more than one element";
}

// Numbers of an attribute of all circles, the markers of the first series, in the order of the drawing.
std::vector<double> circles(const std::string& xml, const std::string& attribute) {
  std::vector<double> values;
  const std::regex circle("<circle[^>]* " + attribute + "=\"([0-9.]+)\"");
  for (std::sregex_iterator i(xml.begin(), xml.end(), circle), none; i != none; ++i) {
    values.push_back(std::strtod(i->str(1).c_str(), nullptr));
  }
  return values;
}

TEST(Chart, LogarithmicScale) {
  EXPECT_DOUBLE_EQ(log_position(10, 10, 1000), 0);
  EXPECT_DOUBLE_EQ(log_position(100, 10, 1000), 0.5);
  EXPECT_DOUBLE_EQ(log_position(1000, 10, 1000), 1);
  EXPECT_DOUBLE_EQ(log_position(2, 1, 8), 1.0 / 3);
  EXPECT_LT(log_position(5, 10, 1000), 0);
}

TEST(Chart, NeighboursAreSpread) {
  EXPECT_EQ(spread({1, 2, 3, 50}, 10), (std::vector<double>{1, 11, 21, 50}));
  EXPECT_EQ(spread({1, 20}, 10), (std::vector<double>{1, 20}));
  EXPECT_TRUE(spread({}, 10).empty());
}

TEST(Chart, IsWellFormed) {
  EXPECT_EQ(fault(svg(example())), "");
  EXPECT_NE(fault("<a><b></a>\n"), "");
  EXPECT_NE(fault("<a>x < y</a>\n"), "");
  EXPECT_NE(fault("<a>x & y</a>\n"), "");
}

TEST(Chart, HasEverySeriesAndPoint) {
  const std::string drawing = svg(example());
  for (const char* library : {"RobCoGen", "A &lt; &quot;B&quot; &amp; C"}) {
    EXPECT_EQ(count(drawing, std::string(">") + library + "</text>"), 1) << "legend";
  }
  for (const char* point :
       {"RobCoGen, Leg: 10 ns", "RobCoGen, Arm: 100 ns", "RobCoGen, Dog: 1000 ns", "C, Dog: 9000 ns"}) {
    EXPECT_EQ(count(drawing, point), 2) << point << ", one a panel";
  }
  EXPECT_EQ(count(drawing, "class=\"marker\""), 2 * 5 + 2);  // the legend's are two
  EXPECT_EQ(count(drawing, "<polyline"), 2 * 2);
  for (const char* label : {">inverse dynamics<", ">forward dynamics<", ">Leg, 2<", ">10 ns<", ">10 µs<"}) {
    EXPECT_GT(count(drawing, label), 0) << label;
  }
}

TEST(Chart, PlacesAreLinearInFreedomAndLogarithmicInTime) {
  const std::string drawing = svg(example());
  const std::vector<double> x = circles(drawing, "cx"), y = circles(drawing, "cy");
  ASSERT_EQ(x.size(), 7);  // one in the legend, three a panel
  for (const std::size_t first : {std::size_t{1}, std::size_t{4}}) {
    EXPECT_NEAR(x[first + 1] - x[first], x[first + 2] - x[first + 1], kPixels);
    EXPECT_GT(x[first + 1], x[first]);
    EXPECT_NEAR(y[first + 1] - y[first], y[first + 2] - y[first + 1], kPixels);
    EXPECT_LT(y[first + 1], y[first]);
  }
  EXPECT_GT(y[4], y[1]) << "the second panel is below the first";
}

TEST(Chart, FloatingBasesAreHollow) {
  const std::string drawing = svg(example());
  const std::regex hollow("fill=\"none\"[^>]*class=\"marker\"[^>]*><title>[^<]*, Dog:");
  const std::sregex_iterator first(drawing.begin(), drawing.end(), hollow);
  EXPECT_EQ(std::distance(first, std::sregex_iterator()), 4);
  EXPECT_EQ(count(drawing, "fill=\"none\""), 4 + 4) << "hollow markers and curves";
}

TEST(Chart, RobotsOfOneFreedomShareALabel) {
  const std::string drawing = svg({{"t", {{"s", {{"Left", 3, false, 10}, {"Right", 3, false, 30}}}}}});
  EXPECT_EQ(count(drawing, ">Left, Right, 3<"), 1);
}

TEST(Chart, TakesWhateverDataThereIs) {
  for (const std::vector<ChartPanel>& panels : std::vector<std::vector<ChartPanel>>{
           {},
           {{"nothing", {}}},
           {{"empty", {{"s", {}}}}},
           {{"one", {{"s", {{"Leg", 2, false, 100}}}}}},
           {{"still", {{"s", {{"Rock", 0, false, 1}}}}}}}) {
    const std::string drawing = svg(panels);
    EXPECT_EQ(fault(drawing), "");
    EXPECT_EQ(count(drawing, "nan") + count(drawing, "inf\""), 0) << drawing;
  }
}

// Relative luminance and contrast of the Web Content Accessibility Guidelines 2.1.
double luminance(const std::string& colour) {
  const auto channel = [&](std::size_t at) {
    const double c = static_cast<double>(std::strtol(colour.substr(at, 2).c_str(), nullptr, 16)) / 255;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

double contrast(const std::string& a, const std::string& b) {
  const double light = std::max(luminance(a), luminance(b)), dark = std::min(luminance(a), luminance(b));
  return (light + 0.05) / (dark + 0.05);
}

// Graphics need a contrast of 3, large text too.
TEST(Chart, ColoursStandOutFromWhiteAndFromDark) {
  EXPECT_NEAR(contrast("#ffffff", "#000000"), 21, 1e-9);
  std::vector<ChartSeries> series;
  for (int i = 0; i < 8; ++i) series.push_back({std::string(1, static_cast<char>('a' + i)), {{"Leg", 2, false, 10}}});
  const std::string drawing = svg({{"t", series}});
  const std::regex colour("\"(#[0-9a-f]{6})\"");
  std::set<std::string> colours;
  for (std::sregex_iterator i(drawing.begin(), drawing.end(), colour), none; i != none; ++i) colours.insert(i->str(1));
  EXPECT_EQ(colours.size(), 9) << "text and eight series";
  for (const std::string& c : colours) {
    for (const char* ground : {"#ffffff", "#0d1117", "#000000"})
      EXPECT_GE(contrast(c, ground), 3) << c << " on " << ground;
  }
}

}  // namespace
}  // namespace robcogen::bench
